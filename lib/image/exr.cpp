#include "image/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "base/error.h"

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

class Memory : public Imf::OStream {
 public:
  Memory() : OStream("a picture") {}
  void write(const char bytes[], int count) override {
    const size_t end = at_ + static_cast<size_t>(count);
    if (bytes_.size() < end) bytes_.resize(end);
    std::copy_n(bytes, count, bytes_.begin() + static_cast<ptrdiff_t>(at_));
    at_ = end;
  }
  uint64_t tellp() override { return at_; }
  void seekp(uint64_t position) override { at_ = position; }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  size_t at_ = 0;
};

}  // namespace

std::string encode_exr(const Image& image) {
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
    Memory memory;
    {                                           // its end writes the table of lines
      Imf::OutputFile file(memory, header, 0);  // no threads: callers save frames in parallel themselves
      file.setFrameBuffer(buffer);
      file.writePixels(static_cast<int>(image.height));
    }
    return memory.take();
  } catch (const std::exception& error) {
    throw IoError(error.what());
  }
}

}  // namespace strad
