// Picture files of every format are read back as written; files that are no pictures are refused in one line.
#include "image/files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("strad-files-test." + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string bytes(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string refusal(const std::string& name) const {
    try {
      load_image(path(name));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  fs::path folder_;
};

Image ramp() {
  Image image(40, 3);
  for (uint32_t i = 0; i < image.pixels.size(); ++i) {
    const float s = static_cast<float>(i) / 120;
    image.pixels[i] = {s, s * s, 1 - s};
  }
  return image;
}

float largest_difference(const Image& a, const Image& b) {
  float largest = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      largest = std::max(largest, std::abs(a.pixels[i][channel] - b.pixels[i][channel]));
  return largest;
}

TEST_F(Files, EveryFormatComesBackWithinItsPrecision) {
  // Steepest slope of the curve from sRGB to linear: 2.28. Half a step of 8 bits: 0.5 / 255. Half floats:
  // 2^-12.
  const struct {
    const char* name;
    float tolerance;
  } formats[] = {{"a.pfm", 0},     {"a.ppm", 0.0046f}, {"a.png", 0.0046f}, {"a.PNG", 0.0046f},
                 {"a.tif", 2e-5f}, {"a.exr", 2.5e-4f}, {"a.hdr", 0.004f}};
  for (const auto& format : formats) {
    save_image(path(format.name), ramp());
    const Image back = load_image(path(format.name));
    ASSERT_EQ(back.width, 40u) << format.name;
    ASSERT_EQ(back.height, 3u) << format.name;
    EXPECT_LE(largest_difference(back, ramp()), format.tolerance) << format.name;
  }
}

TEST_F(Files, ExrKeepsBrightAndNegativeValuesAndStaysFinite) {
  Image image(2, 1);
  image.at(0, 0) = {100, -2, 1e6f};
  save_image(path("a.exr"), image);
  EXPECT_EQ(load_image(path("a.exr")).at(0, 0), (Rgb{100, -2, 65504}));
}

TEST_F(Files, EqualPixelsAreEqualBytes) {
  for (const char* extension : {"exr", "png", "jpg"}) {
    const std::string first = std::string("a.") + extension, second = std::string("b.") + extension;
    save_image(path(first), ramp());
    usleep(1'100'000);  // a time stamp in the file would change
    save_image(path(second), ramp());
    EXPECT_EQ(bytes(first), bytes(second)) << extension;
  }
}

TEST_F(Files, TexturesAreTheBytesOfTheFile) {
  Image image(2, 1);
  image.at(1, 0) = {1, 0.5f, 0};
  for (const char* name : {"t.png", "t.ppm", "t.exr"}) {
    save_image(path(name), image);
    const SrgbImage texture = load_srgb_image(path(name));
    EXPECT_EQ(texture.width, 2u);
    EXPECT_EQ(texture.bytes, (std::vector<uint8_t>{0, 0, 0, 255, 188, 0})) << name;
  }
}

TEST_F(Files, WhatIsNoPictureIsRefusedByName) {
  std::ofstream(path("text.png")) << "no picture";
  std::ofstream(path("empty.exr"));
  std::ofstream(path("short.ppm")) << "P6\n2 2\n255\nabc";
  fs::create_directory(path("folder.png"));
  for (const char* name :
       {"text.png", "empty.exr", "short.ppm", "folder.png", "missing.png", "missing.ppm"}) {
    const std::string text = refusal(name);
    EXPECT_EQ(text.rfind(path(name) + ": ", 0), 0u) << name << ": " << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

TEST_F(Files, TruncatedPicturesAreRefused) {
  for (const char* name : {"a.png", "a.exr", "a.jpg", "a.tif", "a.hdr"}) {
    save_image(path(name), ramp());
    EXPECT_EQ(refusal(name), "") << name;
    fs::resize_file(path(name), fs::file_size(path(name)) * 9 / 10);
    testing::internal::CaptureStderr();
    EXPECT_NE(refusal(name), "") << name;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << name;  // no words of a library's own
  }
}

TEST_F(Files, NothingIsLeftBehindWhenAFileCannotBeWritten) {
  EXPECT_THROW(save_image(path("no/such/folder.exr"), ramp()), IoError);
  EXPECT_THROW(save_image(path("no/such/folder.ppm"), ramp()), IoError);
  fs::create_directory(path("taken.png"));
  EXPECT_THROW(save_image(path("taken.png"), ramp()), IoError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(Files, WhatIsNotFiniteIsRefused) {
  Image image = ramp();
  image.at(7, 1).g = std::nanf("");
  save_image(path("a.exr"), image);
  EXPECT_EQ(refusal("a.exr"), path("a.exr") + ": pixel 7,1 is not finite");
  EXPECT_THROW(load_srgb_image(path("a.exr")), BadInput);
}

TEST_F(Files, UnknownFormatsAreRefusedBeforeAnyWork) {
  for (const char* name : {"a.xyz", "a", "a."}) {
    EXPECT_THROW(require_image_format(path(name)), BadInput) << name;
    EXPECT_THROW(save_image(path(name), ramp()), BadInput) << name;
  }
  require_image_format("a.EXR");
  require_image_format("a.pfm");
}

}  // namespace
}  // namespace strad
