// The files of an export for POV-Ray: all names follow from the pattern of the frames' files.
#pragma once

#include <string>

#include "base/file_pattern.h"

namespace strad {

// For 'out/room.%04d.inc': out/room.ini, out/room.pov, out/room_geometry.inc, out/room_texture1.ppm.
class PovNames {
 public:
  // Throws BadInput unless `pattern` is a FilePattern, numbered when there are several frames, that POV-Ray
  // can read between quotes.
  PovNames(const std::string& pattern, bool several_frames);

  std::string frame(int number) const { return folder_ + file_.name(number); }
  std::string scene() const { return folder_ + base_ + ".pov"; }
  std::string ini() const { return folder_ + base_ + ".ini"; }
  std::string geometry(size_t slab) const;
  std::string texture(size_t material) const;
  // "" or ending in a slash.
  const std::string& folder() const { return folder_; }
  // An expression in POV-Ray's language: the name, without the folder, of the frame numbered `number`.
  std::string frame_expression(const std::string& number) const;

 private:
  std::string folder_;
  FilePattern file_;
  std::string base_;
};

// `path` without its folder.
std::string without_folder(const std::string& path);

}  // namespace strad
