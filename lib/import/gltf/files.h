// Files that a glTF file may name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace strad {

// Whether `path` lies in the folder or below, wherever links lead.
bool is_inside(const std::filesystem::path& path, const std::filesystem::path& folder);

bool is_plain_file(const std::string& path);

// The whole of a file; false if it cannot be read.
bool read_file_bytes(const std::string& path, std::vector<unsigned char>* bytes);

}  // namespace strad
