// How pictures are to be encoded, in the words of a command line.
#pragma once

#include <optional>
#include <string>

#include "image/encoding.h"

namespace strad {

struct EncodingWords {
  std::string tone;             // linear, srgb, filmic; "": not given
  std::string depth;            // half, float, 8, 16; "": not given
  std::optional<double> white;  // radiance
};

// `path` names the pictures' format. Throws BadInput beginning with an option's name unless the format has
// the depth, and whole numbers where a tone or a white is given.
Encoding parse_encoding(const EncodingWords& words, const std::string& path);

}  // namespace strad
