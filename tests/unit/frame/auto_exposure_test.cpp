// The exposure of an unknown animation shows it neither black nor burnt.
#include "frame/auto_exposure.h"

#include <gtest/gtest.h>

namespace strad {
namespace {

const Encoding kSrgb{};

TEST(AutoExposure, EvenLightBecomesMiddleGrey) {
  // 0.045 times 4 is 0.18: 2 stops. The 1/1000 of the mean that is added to every pixel takes log2(1.001),
  // less than half of 1/100, which is what stops are rounded to.
  EXPECT_EQ(exposure_for(std::vector<Rgb>(100, {0.045f, 0.045f, 0.045f}), kSrgb), 2);
  // The same for another white: 8 times the light is in the middle of 8 times the white.
  const Encoding bright{Depth::kUsual, ToneCurve::kSrgb, 8, false};
  EXPECT_EQ(exposure_for(std::vector<Rgb>(100, {0.36f, 0.36f, 0.36f}), bright), 2);
}

TEST(AutoExposure, FewPixelsMayBurnAndMoreMayNot) {
  // Pixels of 0.18, of which 2 or 10 in 100 are 64 times as bright. Only 2: the mean of logarithms grows by
  // 2 % of 6 stops, 0.12, and white does not matter. Of 10 the largest but 2 % is at 11.52, which has to be
  // at most 1: -log2(11.52) = -3.53.
  std::vector<Rgb> pixels(100, {0.18f, 0.18f, 0.18f});
  for (size_t i = 0; i < 2; ++i) pixels[i] = 64 * pixels[i];
  EXPECT_NEAR(exposure_for(pixels, kSrgb), -0.12, 0.011);
  for (size_t i = 2; i < 10; ++i) pixels[i] = 64 * pixels[i];
  EXPECT_NEAR(exposure_for(pixels, kSrgb), -3.53, 0.011);
}

TEST(AutoExposure, FilmicShowsTheSameGrey) {
  const Encoding filmic{Depth::kUsual, ToneCurve::kFilmic, usual_white(ToneCurve::kFilmic), false};
  const double stops = exposure_for(std::vector<Rgb>(100, {1, 1, 1}), filmic);
  EXPECT_NEAR(shown_light(static_cast<float>(std::exp2(stops)), filmic), 0.18, 0.002);
}

TEST(AutoExposure, BlackStaysAsItIs) {
  EXPECT_EQ(exposure_for({}, kSrgb), 0);
  EXPECT_EQ(exposure_for(std::vector<Rgb>(5), kSrgb), 0);
}

}  // namespace
}  // namespace strad
