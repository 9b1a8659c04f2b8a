// A file that is complete or absent: written beside its name and renamed at the end.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "stream/bytes.h"
#include "stream/temporary_file.h"

namespace strad {

// Bytes to a file (complete or absent), or to standard output when `path` is "" or "-". Symbolic links are
// followed, also to a file that is not there yet, so that they stay. Anything but a plain file (/dev/null, a
// named pipe) is written in place.
class Output {
 public:
  explicit Output(const std::string& path);  // throws IoError when it cannot be opened
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool to_terminal() const;
  void write(ByteSpan bytes);
  void write(const std::string& text);
  void commit();  // flushes and renames; throws IoError. Without it the file does not appear.

 private:
  std::string name_;
  std::unique_ptr<TemporaryFile> file_;
  std::FILE* handle_ = nullptr;
};

// `text` as the whole of a file, or to standard output.
void write_text_file(const std::string& path, const std::string& text);

}  // namespace strad
