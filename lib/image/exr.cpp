#include "image/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfFramesPerSecond.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "base/error.h"

namespace strad {
namespace {

constexpr float kLargestHalf = 65504;

std::vector<half> halves_of(const std::vector<float>& samples) {
  std::vector<half> halves;
  halves.reserve(samples.size());
  for (const float sample : samples) halves.emplace_back(std::clamp(sample, -kLargestHalf, kLargestHalf));
  return halves;
}

Imath::M44f matrix_of(const Matrix44& from) {
  Imath::M44f matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      matrix[row][column] = static_cast<float>(from[static_cast<size_t>(4 * row + column)]) + 0.0f;  // no -0
  return matrix;
}

void add_text(Imf::Header* header, const std::string& name, const std::string& text) {
  if (!text.empty()) header->insert(name, Imf::StringAttribute(text));
}

void add_facts(Imf::Header* header, const PictureFacts& facts) {
  Imf::addChromaticities(*header, Imf::Chromaticities());  // Rec. 709 is the default of OpenEXR
  add_text(header, "software", facts.software);
  add_text(header, "provenance", facts.provenance);
  add_text(header, "stream", facts.stream);
  if (facts.rate) Imf::addFramesPerSecond(*header, Imf::guessExactFps(*facts.rate));
  if (facts.screen_width) header->screenWindowWidth() = static_cast<float>(*facts.screen_width);
  if (facts.camera_from_world) Imf::addWorldToCamera(*header, matrix_of(*facts.camera_from_world));
  if (facts.ndc_from_world) Imf::addWorldToNDC(*header, matrix_of(*facts.ndc_from_world));
  if (!facts.frame) return;
  header->insert("frame", Imf::IntAttribute(*facts.frame));
  header->insert("time", Imf::FloatAttribute(static_cast<float>(facts.time)));
  header->insert("exposure", Imf::FloatAttribute(static_cast<float>(facts.exposure)));
  Imf::addExpTime(*header, static_cast<float>(facts.shutter));
}

// `halves` takes the samples of a layer that is not stored as floats.
void add_channels(const Layer& layer, bool as_float, uint32_t width, std::vector<half>* halves,
                  Imf::Header* header, Imf::FrameBuffer* buffer) {
  if (!as_float) *halves = halves_of(layer.samples);
  const size_t size = as_float ? sizeof(float) : sizeof(half);
  const Imf::PixelType type = as_float ? Imf::FLOAT : Imf::HALF;
  // The library only reads from it.
  char* base = as_float ? reinterpret_cast<char*>(const_cast<float*>(layer.samples.data()))
                        : reinterpret_cast<char*>(halves->data());
  const size_t count = layer.channels.size();
  for (size_t c = 0; c < count; ++c) {
    header->channels().insert(channel_name(layer, c), Imf::Channel(type));
    buffer->insert(channel_name(layer, c),
                   Imf::Slice(type, base + c * size, count * size, count * size * width));
  }
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

std::string encode_exr(const LayeredImage& image, Depth depth, const PictureFacts& facts) {
  try {
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    add_facts(&header, facts);
    for (const auto& [name, text] : image.texts) add_text(&header, name, text);
    Imf::FrameBuffer buffer;
    std::vector<std::vector<half>> halves(image.layers.size());
    for (size_t i = 0; i < halves.size(); ++i) {
      const bool as_float = depth == Depth::kFloat || image.layers[i].exact;
      add_channels(image.layers[i], as_float, image.width, &halves[i], &header, &buffer);
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
