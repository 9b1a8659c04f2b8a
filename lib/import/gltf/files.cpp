#include "import/gltf/files.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace strad {

bool is_inside(const std::filesystem::path& path, const std::filesystem::path& folder) {
  std::error_code error, folder_error;
  const auto whole = std::filesystem::weakly_canonical(path, error);
  const auto base = std::filesystem::weakly_canonical(folder, folder_error);
  return !error && !folder_error &&
         std::mismatch(base.begin(), base.end(), whole.begin(), whole.end()).first == base.end();
}

bool is_plain_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

bool read_file_bytes(const std::string& path, std::vector<unsigned char>* bytes) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return false;
  bytes->assign(std::istreambuf_iterator<char>(file), {});
  return !file.bad();
}

}  // namespace strad
