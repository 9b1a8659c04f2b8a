// The only user of OpenImageIO: all picture formats but PPM and PFM, and EXR and PNG to be written.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>

#include "image/module/module.h"
#include "image/srgb.h"

namespace {

using strad::Image;
using strad::kMaxPixels;
using strad::SrgbImage;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

// One thread: callers save frames in parallel, and starting a pool takes longer than a small picture.
void keep_to_one_thread() {
  static const bool done = OIIO::attribute("threads", 1) && OIIO::attribute("exr_threads", -1);
  static_cast<void>(done);
}

// libpng prints its errors and warnings, which OpenImageIO returns as well: while this lives, they go
// nowhere.
class Silence {
 public:
  Silence() : lock_(mutex_), kept_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
    const int nowhere = kept_ >= 0 ? ::open("/dev/null", O_WRONLY | O_CLOEXEC) : -1;
    if (nowhere < 0) return;
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~Silence() {
    if (kept_ < 0) return;
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  static inline std::mutex mutex_;  // the streams of a process are one
  const std::lock_guard<std::mutex> lock_;
  const int kept_;
};

// OpenImageIO fills what is missing of a cut JPEG file with grey. Such a file has no end of image (FF D9)
// after the start of its last scan (FF DA), which are no bytes of coded pixels (ITU T.81, B.1.1.5).
bool is_cut_jpeg(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const size_t scan = bytes.rfind("\xff\xda"), end = bytes.rfind("\xff\xd9");
  return scan != bytes.npos && (end == bytes.npos || end < scan);
}

// Opens `path` and reads its first channels (1 or 3) as `type`, and its alpha, if it has one that is not 1
// everywhere. Colours are as the file has them, not multiplied by alpha where they were not.
template <class Sample>
std::string read_channels(const std::string& path, OIIO::TypeDesc type, OIIO::ImageSpec* spec,
                          std::vector<Sample>* samples, std::vector<Sample>* alpha = nullptr) {
  keep_to_one_thread();
  const Silence silence;
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &config);
  if (!input) return "cannot be read as a picture: " + first_line(OIIO::geterror());
  *spec = input->spec();
  if (spec->width <= 0 || spec->height <= 0 || spec->depth > 1 ||
      static_cast<uint64_t>(spec->width) * static_cast<uint64_t>(spec->height) > kMaxPixels)
    return "found " + std::to_string(spec->width) + " x " + std::to_string(spec->height) +
           " pixels, expected 1 to " + std::to_string(kMaxPixels);
  const int channels = spec->nchannels >= 3 ? 3 : 1;
  samples->resize(static_cast<size_t>(spec->width) * static_cast<size_t>(spec->height) *
                  static_cast<size_t>(channels));
  if (!input->read_image(0, 0, 0, channels, type, samples->data()))
    return "cannot be read: " + first_line(input->geterror());
  if (input->format_name() == std::string("jpeg") && is_cut_jpeg(path))
    return "cannot be read: it is cut off";
  if (alpha && spec->alpha_channel >= 0 && spec->alpha_channel >= channels) {
    alpha->resize(static_cast<size_t>(spec->width) * static_cast<size_t>(spec->height));
    if (!input->read_image(0, 0, spec->alpha_channel, spec->alpha_channel + 1, type, alpha->data()))
      return "cannot be read: " + first_line(input->geterror());
    if (std::all_of(alpha->begin(), alpha->end(), [](Sample a) { return a >= 1; })) alpha->clear();
  }
  spec->nchannels = channels;
  for (size_t i = 0; i < samples->size(); ++i) {
    if (std::isfinite((*samples)[i])) continue;
    const size_t pixel = i / static_cast<size_t>(channels), width = static_cast<size_t>(spec->width);
    return "pixel " + std::to_string(pixel % width) + "," + std::to_string(pixel / width) + " is not finite";
  }
  return "";
}

std::string read(const std::string& path, Image* image) {
  OIIO::ImageSpec spec;
  std::vector<float> samples;
  if (const std::string fault = read_channels(path, OIIO::TypeDesc::FLOAT, &spec, &samples); !fault.empty())
    return fault;
  if (!spec.format.is_floating_point())
    for (float& sample : samples) sample = strad::linear_from_srgb(sample);
  *image = Image(static_cast<uint32_t>(spec.width), static_cast<uint32_t>(spec.height));
  const float* sample = samples.data();
  for (strad::Rgb& pixel : image->pixels) {
    pixel = spec.nchannels == 3 ? strad::Rgb{sample[0], sample[1], sample[2]}
                                : strad::Rgb{sample[0], sample[0], sample[0]};
    sample += spec.nchannels;
  }
  return "";
}

std::string read_srgb(const std::string& path, SrgbImage* image) {
  OIIO::ImageSpec spec;
  std::vector<float> samples, alpha;  // floats, since those of EXR are linear and may exceed 1
  if (const std::string fault = read_channels(path, OIIO::TypeDesc::FLOAT, &spec, &samples, &alpha);
      !fault.empty())
    return fault;
  image->width = static_cast<uint32_t>(spec.width);
  image->height = static_cast<uint32_t>(spec.height);
  const bool linear = spec.format.is_floating_point();
  const auto byte = [&](float sample) {
    return linear ? strad::srgb_byte(sample) : static_cast<uint8_t>(255 * sample + 0.5f);
  };
  image->bytes.reserve(size_t{3} * image->width * image->height);
  for (size_t i = 0; i < samples.size(); ++i)
    image->bytes.insert(image->bytes.end(), spec.nchannels == 3 ? 1 : 3, byte(samples[i]));
  for (const float a : alpha)
    image->alpha.push_back(static_cast<uint8_t>(255 * std::clamp(a, 0.0f, 1.0f) + 0.5f));
  return "";
}

bool is_float_format(const std::string& format) { return format == "hdr" || format == "rgbe"; }
bool has_words(const std::string& format, bool eight_bits) {
  return !eight_bits && (format == "tif" || format == "tiff");
}

OIIO::ImageSpec spec_for(const Image& image, const std::string& format, bool eight_bits) {
  const OIIO::TypeDesc type = is_float_format(format)         ? OIIO::TypeDesc::FLOAT
                              : has_words(format, eight_bits) ? OIIO::TypeDesc::UINT16
                                                              : OIIO::TypeDesc::UINT8;
  OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height), 3, type);
  spec.attribute("DateTime",
                 "1970:01:01 00:00:00");  // not the current time: equal pixels must give equal bytes
  spec.attribute("compression", format == "jpg" || format == "jpeg" ? "jpeg:95" : "zip");
  spec.attribute("oiio:ColorSpace", is_float_format(format) ? "Linear" : "sRGB");
  return spec;
}

std::vector<float> floats_of(const Image& image) {
  std::vector<float> samples;
  samples.reserve(3 * image.pixels.size());
  for (const strad::Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) samples.push_back(pixel[channel]);
  return samples;
}

template <class Sample, class Encode>
std::vector<Sample> whole_numbers_of(const Image& image, Encode encode) {
  std::vector<Sample> samples;
  samples.reserve(3 * image.pixels.size());
  for (const strad::Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) samples.push_back(encode(pixel[channel]));
  return samples;
}

bool write_samples(OIIO::ImageOutput* output, const std::string& format, bool eight_bits,
                   const Image& image) {
  if (is_float_format(format)) return output->write_image(OIIO::TypeDesc::FLOAT, floats_of(image).data());
  if (has_words(format, eight_bits))
    return output->write_image(OIIO::TypeDesc::UINT16,
                               whole_numbers_of<uint16_t>(image, strad::srgb_word).data());
  return output->write_image(OIIO::TypeDesc::UINT8,
                             whole_numbers_of<uint8_t>(image, strad::srgb_byte).data());
}

bool knows(const std::string& format) {
  keep_to_one_thread();
  const bool known = OIIO::ImageOutput::create(format) != nullptr;
  if (!known) OIIO::geterror();  // clears it
  return known;
}

// A file in memory, under a name.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("picture", MFD_CLOEXEC)) {}
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
  std::string bytes() const {
    std::ifstream file(name(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  int descriptor_;
};

// In plain memory, for a disk may be full: libjpeg then ends the program, and others do not tell. Some
// formats are written by name only; TIFF comes out damaged from IOVecOutput in OpenImageIO 2.4.
std::string encode(const std::string& format, bool eight_bits, const Image& image, std::string* bytes) {
  keep_to_one_thread();
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (!output) return "no writer for this format: " + first_line(OIIO::geterror());
  OIIO::Filesystem::IOVecOutput memory;
  const bool by_name = format == "tif" || format == "tiff" || !output->supports("ioproxy");
  const MemoryFile file;
  if (!by_name) output->set_ioproxy(&memory);
  if (!output->open(by_name ? file.name() : "picture." + format, spec_for(image, format, eight_bits)) ||
      !write_samples(output.get(), format, eight_bits, image) || !output->close())
    return "cannot be written: " + first_line(output->geterror());
  *bytes = by_name ? file.bytes() : std::string(memory.buffer().begin(), memory.buffer().end());
  // Even a file in memory may meet a limit (ulimit -f), which some writers do not tell.
  Image back;
  if (by_name && !read(file.name(), &back).empty()) return "cannot be written: File too large";
  return "";
}

constexpr strad::ImageModule kModule{read, read_srgb, knows, encode};

}  // namespace

extern "C" const strad::ImageModule* strad_image_module() { return &kModule; }
