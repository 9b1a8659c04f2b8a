// POV-Ray scene files as tokens.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace strad {

enum class PovKind : uint8_t {
  kEnd,
  kWord,  // identifiers and keywords
  kNumber,
  kString,     // text without its quotes, as written
  kSymbol,     // one character, or one of <= >= !=
  kDirective,  // a word after #
};

struct PovToken {
  PovKind kind = PovKind::kEnd;
  uint32_t line = 0;
  std::string_view text;  // of the file's text
  double number = 0;
};

struct PovFile {
  std::string path;
  std::string name;  // as messages call it
  std::string text;
  std::vector<PovToken> tokens;  // the last is kEnd
};

// Throws IoError, or BadInput with file and line.
std::shared_ptr<const PovFile> read_pov_file(const std::string& path);
// The same of text that is already there. `name`: as messages call it.
std::shared_ptr<const PovFile> pov_file_of(std::string text, const std::string& name);

}  // namespace strad
