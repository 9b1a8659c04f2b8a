// Netpbm's PPM (netpbm.sourceforge.net/doc/ppm.html) and Debevec's PFM, both written byte by byte.
#include "image/pnm.h"

#include <bit>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "image/srgb.h"

namespace strad {
namespace {

void put_float(std::string* bytes, float value) {
  const uint32_t bits = std::bit_cast<uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) bytes->push_back(static_cast<char>(bits >> shift));
}

float get_float(const unsigned char* p, bool little) {
  const auto byte = [&](int i) { return uint32_t{p[little ? i : 3 - i]} << (8 * i); };
  return std::bit_cast<float>(byte(0) | byte(1) | byte(2) | byte(3));
}

std::string header(const char* magic, const Image& image, const char* last) {
  return std::string(magic) + "\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n" +
         last + "\n";
}

// The words of the header, separated by white space and comments.
class Header {
 public:
  Header(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::string_view word() {
    skip_space();
    const size_t begin = at_;
    while (at_ < bytes_.size() && !is_space(bytes_[at_])) ++at_;
    return bytes_.substr(begin, at_ - begin);
  }
  template <class Number>
  Number number(const char* expected) {
    const std::string_view text = word();
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      throw BadInput(name_ + ": found '" + std::string(text.substr(0, 20)) + "' in its header, expected " +
                     expected);
    return value;
  }
  // The data, which begins after the one white space that ends the header.
  std::string_view rest() const { return at_ < bytes_.size() ? bytes_.substr(at_ + 1) : std::string_view{}; }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_space() {
    while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
      if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size() - 1);
      ++at_;
    }
  }
  std::string_view bytes_;
  const std::string& name_;
  size_t at_ = 0;
};

const unsigned char* samples_of(std::string_view data, uint64_t expected, const std::string& name) {
  if (data.size() != expected)
    throw BadInput(name + ": found " + std::to_string(data.size()) + " bytes of pixels, expected " +
                   std::to_string(expected));
  return reinterpret_cast<const unsigned char*>(data.data());
}

void read_ppm_pixels(std::string_view data, uint32_t maximum, const std::string& name, Image* image) {
  if (!(maximum >= 1 && maximum <= 65535))
    throw BadInput(name + ": found maximum " + std::to_string(maximum) + ", expected 1 to 65535");
  const uint64_t width = maximum > 255 ? 2 : 1;  // bytes per sample, the high one first
  const unsigned char* sample = samples_of(data, image->width * uint64_t{image->height} * 3 * width, name);
  image->pixels.resize(size_t{image->width} * image->height);
  for (Rgb& pixel : image->pixels)
    for (int channel = 0; channel < 3; ++channel, sample += width) {
      const int value = width == 2 ? 256 * sample[0] + sample[1] : sample[0];
      pixel[channel] = linear_from_srgb(static_cast<float>(value) / static_cast<float>(maximum));
    }
}

void read_pfm_pixels(std::string_view data, float scale, bool grey, const std::string& name, Image* image) {
  if (!(std::abs(scale) > 0)) throw BadInput(name + ": found scale 0, expected a byte order");
  const size_t channels = grey ? 1 : 3;
  const unsigned char* samples =
      samples_of(data, image->width * uint64_t{image->height} * 4 * channels, name);
  image->pixels.resize(size_t{image->width} * image->height);
  for (uint32_t y = 0; y < image->height; ++y)
    for (uint32_t x = 0; x < image->width; ++x) {
      const size_t pixel = size_t{image->height - 1 - y} * image->width + x;  // rows from the bottom
      for (size_t channel = 0; channel < 3; ++channel)
        image->at(x, y)[static_cast<int>(channel)] =
            get_float(samples + 4 * (pixel * channels + (grey ? 0 : channel)), scale < 0);
      if (!is_finite(image->at(x, y)))
        throw BadInput(name + ": pixel " + std::to_string(x) + "," + std::to_string(y) + " is not finite");
    }
}

}  // namespace

std::string encode_ppm(const Image& image, const Encoding& encoding) {
  const bool words = encoding.depth == Depth::kWord;
  std::string bytes = header("P6", image, words ? "65535" : "255");
  bytes.reserve(bytes.size() + (words ? 6 : 3) * image.pixels.size());
  if (words) {
    for (const uint16_t word : words_of(image, encoding)) {
      bytes.push_back(static_cast<char>(word >> 8));
      bytes.push_back(static_cast<char>(word & 255));
    }
  } else {
    for (const uint8_t byte : bytes_of(image, encoding)) bytes.push_back(static_cast<char>(byte));
  }
  return bytes;
}

std::string encode_pfm(const Image& image) {
  std::string bytes = header("PF", image, "-1.0");  // negative: little-endian
  bytes.reserve(bytes.size() + 12 * image.pixels.size());
  for (uint32_t y = image.height; y-- > 0;)
    for (uint32_t x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 3; ++channel) put_float(&bytes, image.at(x, y)[channel]);
  return bytes;
}

bool is_pnm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '6' || bytes[1] == 'F' || bytes[1] == 'f');
}

Image decode_pnm(std::string_view bytes, const std::string& name) {
  Header header(bytes, name);
  const std::string_view magic = header.word();
  if (magic != "P6" && magic != "PF" && magic != "Pf")
    throw BadInput(name + ": found '" + std::string(magic.substr(0, 8)) + "', expected P6, PF or Pf");
  Image image;
  image.width = header.number<uint32_t>("a width");
  image.height = header.number<uint32_t>("a height");
  if (image.width == 0 || image.height == 0 || uint64_t{image.width} * image.height > kMaxPixels)
    throw BadInput(name + ": found " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                   " pixels, expected 1 to " + std::to_string(kMaxPixels));
  if (magic == "P6") {
    const uint32_t maximum = header.number<uint32_t>("a maximum");
    read_ppm_pixels(header.rest(), maximum, name, &image);
  } else {
    const float scale = header.number<float>("a scale");
    read_pfm_pixels(header.rest(), scale, magic == "Pf", name, &image);
  }
  return image;
}

}  // namespace strad
