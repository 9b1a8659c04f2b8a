#include "image/files.h"

#include <dlfcn.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>

#include "base/error.h"
#include "image/exr.h"
#include "image/module/module.h"
#include "image/png.h"
#include "image/pnm.h"
#include "image/srgb.h"
#include "stream/output_file.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

// Beside the executable, in the build tree as when installed: bin/strad-frame,
// lib/strad/strad-image-files.so.
const ImageModule* open_module() {
  const fs::path executable = fs::read_symlink("/proc/self/exe");
  const std::string path =
      (executable.parent_path().parent_path() / "lib/strad/strad-image-files.so").string();
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw IoError(std::string("cannot load the module for picture files: ") + dlerror());
  void* entry = dlsym(library, kImageModuleSymbol);
  if (!entry) throw IoError(path + ": found no " + kImageModuleSymbol + " in it");
  return reinterpret_cast<ImageModuleEntry>(entry)();
}

const ImageModule& module() {
  static const ImageModule* const loaded = open_module();
  return *loaded;
}

bool is_pnm_format(const std::string& format) { return format == "ppm" || format == "pfm"; }

// Formats that are written without the module.
bool is_own_format(const std::string& format) {
  return is_pnm_format(format) || format == "exr" || format == "png";
}

std::string read_all(std::istream& stream, const std::string& name) {
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw IoError(name + ": cannot be read");
  return bytes;
}

std::string read_file(const std::string& path) {
  if (path == "-") return read_all(std::cin, "standard input");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path + ": " + std::strerror(errno));
  return read_all(file, path);
}

void require_regular_file(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw IoError(path + ": no such file");
  if (fs::is_directory(status)) throw BadInput(path + ": found a directory, expected a picture");
  if (!fs::is_regular_file(status))  // a pipe or a device may never end
    throw BadInput(path + ": is no plain file, expected a picture");
}

// The module puts light on the sRGB curve; numbers that are to be in proportion to light pass it unchanged.
std::string encode_by_module(const std::string& format, const Image& image, const Encoding& encoding) {
  std::string bytes, fault;
  const bool eight = encoding.depth == Depth::kByte;
  if (is_float(encoding.depth)) {
    fault = module().encode(format, eight, image, &bytes);
  } else {
    Image shown = shown_light(image, encoding);
    if (encoding.tone == ToneCurve::kLinear) {
      for (Rgb& pixel : shown.pixels)
        for (int c = 0; c < 3; ++c) pixel[c] = linear_from_srgb(pixel[c]);
    }
    fault = module().encode(format, eight, shown, &bytes);
  }
  if (!fault.empty()) throw IoError(fault);
  return bytes;
}

// The bytes of a picture file. Throws IoError without the file's name.
std::string encode_image(const std::string& format, const Image& image, const Encoding& encoding,
                         const PictureFacts& facts) {
  if (format == "ppm") return encode_ppm(image, encoding);
  if (format == "pfm") return encode_pfm(image);
  if (format == "png") return encode_png(image, encoding, facts);
  if (format == "exr")
    return encode_exr({image.width, image.height, {layer_of(image, "")}, {}}, encoding.depth, facts);
  return encode_by_module(format, image, encoding);
}

void write_whole(const std::string& path, const std::function<std::string()>& encode) {
  Output output(path);
  std::string bytes;
  try {
    bytes = encode();
  } catch (const IoError& error) {
    throw IoError(path + ": " + error.what());
  }
  output.write(bytes);
  output.commit();
}

}  // namespace

std::string format_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

Image load_image(const std::string& path) {
  if (path == "-") return decode_pnm(read_file(path), "standard input");
  require_regular_file(path);
  if (is_pnm_format(format_of(path))) return decode_pnm(read_file(path), path);
  Image image;
  const std::string fault = module().read(path, &image);
  if (!fault.empty()) throw BadInput(path + ": " + fault);
  return image;
}

SrgbImage load_srgb_image(const std::string& path) {
  SrgbImage texture;
  require_regular_file(path);
  if (!is_pnm_format(format_of(path))) {
    const std::string fault = module().read_srgb(path, &texture);
    if (!fault.empty()) throw BadInput(path + ": " + fault);
    return texture;
  }
  const Image image = decode_pnm(read_file(path), path);
  texture = {image.width, image.height, {}};
  texture.bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) texture.bytes.push_back(srgb_byte(pixel[channel]));
  return texture;
}

void require_image_format(const std::string& path) {
  const std::string format = format_of(path);
  if (is_own_format(format) || (!format.empty() && module().knows(format))) return;
  throw BadInput(path + ": found the extension '" + format +
                 "', expected one of a picture format, such as exr, png, ppm, pfm");
}

void save_layers(const std::string& path, const LayeredImage& image, Depth depth, const PictureFacts& facts) {
  write_whole(path, [&] { return encode_exr(image, depth, facts); });
}

void save_image(const std::string& path, const Image& image, const Encoding& encoding,
                const PictureFacts& facts) {
  require_image_format(path);
  const std::string format = format_of(path);
  Encoding known = encoding;
  if (known.depth == Depth::kUsual) known.depth = depths_of(format).front();
  write_whole(path, [&] { return encode_image(format, image, known, facts); });
}

}  // namespace strad
