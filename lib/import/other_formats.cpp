#include "import/other_formats.h"

#include <array>
#include <fstream>
#include <string_view>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

namespace strad {
namespace {

using namespace std::literals;

struct KnownFormat {
  std::string_view begins, is, advice;
};

// What Blender, Maya and their like write, and what strad's own tools do.
constexpr std::array<KnownFormat, 14> kFormats{{
    {"glTF"sv, "a glTF 2.0 file", "use --from gltf"},
    {"\x89STR\r\n"sv, "a strad stream", "it is imported already"},
    {"BLENDER"sv, "a Blender file", "export it as glTF 2.0"},
    {"Kaydara FBX"sv, "an FBX file", "convert it to glTF 2.0"},
    {"; FBX"sv, "an FBX file", "convert it to glTF 2.0"},
    {"ply\n"sv, "a PLY file", "convert it to OBJ"},
    {"ply\r"sv, "a PLY file", "convert it to OBJ"},
    {"PXR-USDC"sv, "a USD file", "convert it to glTF 2.0"},
    {"#usda"sv, "a USD file", "convert it to glTF 2.0"},
    {"PK\x03\x04"sv, "a ZIP archive", "unpack it"},
    {"\x1f\x8b"sv, "a gzip archive", "unpack it"},
    {"<?xml"sv, "an XML file, such as COLLADA", "convert it to glTF 2.0"},
    {"\x89PNG"sv, "a PNG picture", "scenes are OBJ, POV-Ray or glTF files"},
    {"Ogawa"sv, "an Alembic file", "convert it to glTF 2.0"},
}};

// JSON that begins like glTF: an object whose text names an asset.
bool is_gltf_text(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  return first != text.npos && text[first] == '{' && text.find("\"asset\"") != text.npos;
}

}  // namespace

void refuse_other_format(const std::string& path, const std::string& format) {
  if (format == "gltf" || !is_plain_file(path)) return;  // what is read from a pipe is gone
  std::ifstream file(path, std::ios::binary);
  std::string head(4096, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<size_t>(file.gcount()));
  for (const KnownFormat& known : kFormats)
    if (head.starts_with(known.begins))
      throw BadInput(text_name(path) + ": is " + std::string(known.is) + ": " + std::string(known.advice));
  if (is_gltf_text(head)) throw BadInput(text_name(path) + ": is a glTF 2.0 file: use --from gltf");
}

}  // namespace strad
