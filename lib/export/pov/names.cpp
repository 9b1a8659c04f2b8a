#include "export/pov/names.h"

#include <algorithm>

#include "base/error.h"
#include "export/pov/text.h"

namespace strad {
namespace {

[[noreturn]] void refuse(const std::string& pattern, const std::string& why) {
  throw BadInput("--output: found '" + pattern + "', expected " + why);
}

std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

// The part of the name before the number, without the separator; without a number, the name up to its
// extension.
std::string base_of(const FilePattern& file) {
  std::string base = file.before();
  base.erase(file.numbered() ? base.find_last_not_of(".-_ ") + 1 : std::min(base.rfind('.'), base.size()));
  return base.empty() ? "strad" : base;
}

bool quotable(const std::string& text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < 32; });
}

}  // namespace

std::string without_folder(const std::string& path) { return path.substr(path.rfind('/') + 1); }

PovNames::PovNames(const std::string& pattern, bool several_frames)
    : folder_(folder_of(pattern)), file_("--output", without_folder(pattern)), base_(base_of(file_)) {
  if (!quotable(pattern))
    refuse(pattern, "no quotes, backslashes or control characters, which POV-Ray cannot read");
  if (folder_.find('%') != std::string::npos)
    refuse(pattern, "the number in the file's name, not in its folder's");
  if (several_frames && !file_.numbered())
    refuse(pattern, "a number for several frames, such as room.%04d.inc");
  for (const std::string& taken : {scene(), ini(), geometry(0)}) {
    if (!file_.numbered() && taken == pattern)
      refuse(pattern, "another name, since '" + taken + "' is written too");
  }
}

std::string PovNames::geometry(size_t slab) const {
  return folder_ + base_ + "_geometry" + (slab == 0 ? "" : std::to_string(slab + 1)) + ".inc";
}

std::string PovNames::texture(size_t material) const {
  return folder_ + base_ + "_texture" + std::to_string(material + 1) + ".ppm";
}

std::string PovNames::frame_expression(const std::string& number) const {
  PovText out;
  out << "\"" << file_.before() << "\"";
  if (!file_.numbered()) return out.take();
  const char* fill = file_.fill() == '0' ? "-" : "";  // POV-Ray fills with zeros where the width is negative
  PovText expression;
  expression << "concat(" << out.take() << ", str(" << number << ", " << fill << file_.width() << ", 0), \""
             << file_.after() << "\")";
  return expression.take();
}

}  // namespace strad
