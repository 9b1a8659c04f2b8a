#include "image/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <exception>
#include <vector>

namespace strad {
namespace {

constexpr float kLargestHalf = 65504;
constexpr const char* kChannels[3] = {"R", "G", "B"};

std::vector<half> halves_of(const Image& image) {
  std::vector<half> samples;
  samples.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (int c = 0; c < 3; ++c) samples.emplace_back(std::clamp(pixel[c], -kLargestHalf, kLargestHalf));
  return samples;
}

}  // namespace

std::string write_exr(const std::string& path, const Image& image) {
  try {
    std::vector<half> samples = halves_of(image);
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 3; ++c) {
      header.channels().insert(kChannels[c], Imf::Channel(Imf::HALF));
      buffer.insert(kChannels[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(samples.data() + c),
                                             3 * sizeof(half), 3 * sizeof(half) * image.width));
    }
    Imf::OutputFile file(path.c_str(), header, 0);  // no threads: callers save frames in parallel themselves
    file.setFrameBuffer(buffer);
    file.writePixels(static_cast<int>(image.height));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace strad
