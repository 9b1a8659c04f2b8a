// Files of other formats, known by their first bytes.
#pragma once

#include <string>

namespace strad {

// Throws BadInput, which says what the file is and how to read it, if its first bytes are those of a format
// other than `format`, one of obj, pov, ini and gltf. Says nothing of what it does not know, nor of standard
// input.
void refuse_other_format(const std::string& path, const std::string& format);

}  // namespace strad
