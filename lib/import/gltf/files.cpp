#include "import/gltf/files.h"

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

namespace strad {

bool is_inside(const std::filesystem::path& path, const std::filesystem::path& folder) {
  std::error_code error, folder_error;
  const auto whole = std::filesystem::weakly_canonical(path, error);
  const auto base = std::filesystem::weakly_canonical(folder, folder_error);
  return !error && !folder_error &&
         std::mismatch(base.begin(), base.end(), whole.begin(), whole.end()).first == base.end();
}

namespace {

// `check` sees all that was read so far.
void append_blocks(const std::string& path, std::vector<unsigned char>* bytes,
                   const std::function<void(std::string_view block)>& check) {
  constexpr size_t kMost = 0x7fffffff;
  read_blocks(path, "a glTF file", [&](std::string_view block) {
    bytes->insert(bytes->end(), block.begin(), block.end());
    if (bytes->size() > kMost) throw BadInput(text_name(path) + ": is longer than 2 GiB");
    check(block);
  });
}

}  // namespace

void append_file(const std::string& path, std::vector<unsigned char>* bytes) {
  append_blocks(path, bytes, [](std::string_view) {});
}

std::vector<unsigned char> gltf_scene_bytes(const std::string& path) {
  std::vector<unsigned char> bytes;
  const auto is_binary = [&bytes] { return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0; };
  const auto refuse = [&path] { throw BadInput(text_name(path) + ": is not a glTF file"); };
  append_blocks(path, &bytes, [&](std::string_view block) {
    if (bytes.size() >= 4 && !is_binary() && block.find('\0') != block.npos) refuse();
  });
  if (bytes.size() < 4) refuse();
  return bytes;
}

}  // namespace strad
