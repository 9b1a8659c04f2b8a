// Files that a glTF file may name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace strad {

// Whether `path` lies in the folder or below, wherever links lead.
bool is_inside(const std::filesystem::path& path, const std::filesystem::path& folder);

// Adds the bytes of a file. Throws BadInput beyond 2 GiB, since tinygltf counts in int, and like read_blocks.
void append_file(const std::string& path, std::vector<unsigned char>* bytes);

// The bytes of a glTF scene. Throws BadInput for what is neither binary glTF nor text, without reading all of
// it.
std::vector<unsigned char> gltf_scene_bytes(const std::string& path);

}  // namespace strad
