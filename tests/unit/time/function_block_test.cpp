// Functions of time in few bits: how far they are from what was put in.
#include "time/function_block.h"

#include <gtest/gtest.h>

#include "base/rng.h"
#include "time/scaled_function.h"

namespace strad {
namespace {

constexpr size_t kTimes = 37;
const std::vector<uint32_t> kLeaves{2, 3, 11};

// Over nine powers of ten.
Rgb value(uint64_t leaf, uint64_t time_sample) {
  const auto channel = [&](uint64_t c) {
    return static_cast<float>(std::pow(10.0, 9 * unit_from(hash_of(leaf, time_sample, c)) - 5));
  };
  return {channel(0), channel(1), channel(2)};
}

FunctionBlock filled() {
  FunctionBlock functions(12, kLeaves, kTimes);
  for (const uint32_t leaf : {11u, 2u, 3u})  // in any order
    for (size_t t = 0; t < kTimes; ++t) functions.set(leaf, t, value(leaf, t));
  return functions;
}

TEST(FunctionBlock, KeepsThreeDigits) {
  const FunctionBlock functions = filled();
  for (const uint32_t leaf : kLeaves)
    for (size_t t = 0; t < kTimes; ++t)
      for (int c = 0; c < 3; ++c) {
        const float expected = value(leaf, t)[c];
        EXPECT_NEAR(functions.get(leaf, t)[c], expected, 0.004f * expected);
      }
}

// Rounding is to the nearest: what many add up to is right.
TEST(FunctionBlock, RoundsToNearest) {
  FunctionBlock functions(1, {0}, 10000);
  double sum = 0, expected = 0;
  for (size_t t = 0; t < 10000; ++t) {
    const auto v = static_cast<float>(1 + unit_from(hash_of(t)));
    functions.set(0, t, {v, v, v});
    sum += static_cast<double>(functions.get(0, t).r);
    expected += static_cast<double>(v);
  }
  EXPECT_NEAR(sum / expected, 1, 1e-4);
}

TEST(FunctionBlock, BeginsAtZero) {
  const FunctionBlock functions(12, kLeaves, kTimes);
  EXPECT_EQ(functions.get(3, 5), Rgb{});
  EXPECT_TRUE(functions.has(2));
  EXPECT_FALSE(functions.has(4));
  EXPECT_EQ(functions.rows(), kLeaves);
}

TEST(FunctionBlock, AddIsTheSum) {
  const FunctionBlock functions = filled();
  std::vector<float> weights, sums(3 * kTimes, 2.0f);
  for (size_t t = 0; t < kTimes; ++t) weights.push_back(static_cast<float>(unit_from(hash_of(t, 8))));
  functions.add(3, 7, 27, weights.data(), sums.data());
  for (size_t t = 0; t < kTimes; ++t)
    for (size_t c = 0; c < 3; ++c) {
      const float added = t < 7 || t >= 27 ? 0 : weights[t] * functions.get(3, t)[static_cast<int>(c)];
      EXPECT_FLOAT_EQ(sums[c * kTimes + t], 2 + added) << t;
    }
}

// Errors are in units of the function's own largest value.
template <typename Function>
void expect_kept(double red_and_green, double blue) {
  std::vector<Rgb> values;
  for (uint64_t i = 0; i < 500; ++i) {
    const auto random = [&](uint64_t c) { return static_cast<float>(40 * unit_from(hash_of(i, c, 9))); };
    values.push_back({random(0), random(1), random(2)});
  }
  values[123] = {40, 40, 40};
  values[45] = {};
  const Function packed(values);
  ASSERT_EQ(packed.size(), values.size());
  for (size_t i = 0; i < values.size(); ++i) {
    EXPECT_NEAR(packed[i].r, values[i].r, 40 * red_and_green);
    EXPECT_NEAR(packed[i].g, values[i].g, 40 * red_and_green);
    EXPECT_NEAR(packed[i].b, values[i].b, 40 * blue);
  }
  EXPECT_EQ(packed[45], Rgb{});
  EXPECT_FLOAT_EQ(packed[123].b, 40);
}

TEST(FineFunction, KeepsSixteenBits) { expect_kept<FineFunction>(0.51 / 65535, 0.51 / 65535); }
TEST(CoarseFunction, KeepsElevenElevenAndTenBits) { expect_kept<CoarseFunction>(0.51 / 2047, 0.51 / 1023); }

TEST(FineFunction, ZeroAndEmptyFunctions) {
  EXPECT_TRUE(FineFunction().empty());
  EXPECT_TRUE(CoarseFunction().empty());
  EXPECT_EQ(FineFunction(std::vector<Rgb>(3))[1], Rgb{});
  EXPECT_EQ(CoarseFunction(std::vector<Rgb>(3))[1], Rgb{});
}

}  // namespace
}  // namespace strad
