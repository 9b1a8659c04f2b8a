#include "image/png.h"

#include <png.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#include "base/error.h"

namespace strad {
namespace {

struct Entry {
  std::string keyword, text;
};

std::string shortest(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

// Keywords of the PNG specification where it has them, else strad's own.
std::vector<Entry> entries_of(const PictureFacts& facts) {
  std::vector<Entry> entries;
  const auto add = [&](const char* keyword, const std::string& text) {
    if (!text.empty()) entries.push_back({keyword, text});
  };
  add("Software", facts.software);
  add("Comment", facts.provenance);
  add("stream", facts.stream);
  if (!facts.frame) return entries;
  add("frame", std::to_string(*facts.frame));
  add("time", shortest(facts.time));
  if (facts.rate) add("framesPerSecond", shortest(*facts.rate));
  add("exposure", shortest(facts.exposure));
  return entries;
}

// What libpng is given. Plain pointers: its errors jump over destructors.
struct PngContent {
  png_structp png;
  png_infop info;
  std::FILE* file;
  png_textp texts;
  int text_count;
  png_bytepp rows;
  png_uint_32 width, height;
  int bits;
  bool linear;
};

void keep_message(png_structp png, png_const_charp text) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = text;
  png_longjmp(png, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

bool write_content(const PngContent& content) {
  if (setjmp(png_jmpbuf(content.png))) return false;
  png_init_io(content.png, content.file);
  png_set_IHDR(content.png, content.info, content.width, content.height, content.bits, PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (content.linear) {
    png_set_gAMA_fixed(content.png, content.info, PNG_GAMMA_LINEAR);
    // Rec. 709 primaries and its white D65, as sRGB has them, in units of 1/100000.
    png_set_cHRM_fixed(content.png, content.info, 31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000);
  } else {
    png_set_sRGB_gAMA_and_cHRM(content.png, content.info, PNG_sRGB_INTENT_RELATIVE);
  }
  if (content.text_count > 0) png_set_text(content.png, content.info, content.texts, content.text_count);
  png_write_info(content.png, content.info);
  png_write_image(content.png, content.rows);
  png_write_end(content.png, nullptr);
  return true;
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

std::vector<png_text> png_texts(std::vector<Entry>* entries) {
  std::vector<png_text> texts;
  for (Entry& entry : *entries) {
    png_text text{};
    text.compression = is_ascii(entry.text) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = entry.keyword.data();
    text.text = entry.text.data();
    text.text_length = entry.text.size();
    texts.push_back(text);
  }
  return texts;
}

// The high byte first.
std::vector<uint8_t> samples_of(const Image& image, const Encoding& encoding) {
  if (encoding.depth != Depth::kWord) return bytes_of(image, encoding);
  std::vector<uint8_t> samples;
  samples.reserve(6 * image.pixels.size());
  for (const uint16_t word : words_of(image, encoding)) {
    samples.push_back(static_cast<uint8_t>(word >> 8));
    samples.push_back(static_cast<uint8_t>(word & 255));
  }
  return samples;
}

}  // namespace

std::string encode_png(const Image& image, const Encoding& encoding, const PictureFacts& facts) {
  std::vector<uint8_t> samples = samples_of(image, encoding);
  std::vector<png_bytep> rows;
  for (uint32_t y = 0; y < image.height; ++y)
    rows.push_back(samples.data() + samples.size() / image.height * y);
  std::vector<Entry> entries = entries_of(facts);
  std::vector<png_text> texts = png_texts(&entries);
  std::string fault = "libpng could not be started";
  char* encoded = nullptr;
  size_t size = 0;
  std::FILE* const memory = ::open_memstream(&encoded, &size);
  if (!memory) throw std::bad_alloc();
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &fault, keep_message, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool linear = encoding.tone == ToneCurve::kLinear;
  const bool done =
      info && write_content({png, info, memory, texts.data(), static_cast<int>(texts.size()), rows.data(),
                             image.width, image.height, encoding.depth == Depth::kWord ? 16 : 8, linear});
  png_destroy_write_struct(&png, &info);
  const bool closed = std::fclose(memory) == 0;
  const std::unique_ptr<char, void (*)(void*)> owner(encoded, std::free);
  if (!done) throw IoError(fault);
  if (!closed) throw std::bad_alloc();
  return {encoded, size};
}

}  // namespace strad
