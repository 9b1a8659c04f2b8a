// A file that is written under a name of its own, and takes the place of another when it is complete.
#pragma once

#include <string>

namespace strad {

// The name is random, and the file is created by this process alone: neither a link nor a file that somebody
// put in its way is ever written. It is removed by the destructor, and when a signal ends the program. The
// lock on it tells whether its program still lives: files that killed programs left in the same folder are
// removed.
class TemporaryFile {
 public:
  // In the folder of `path`, whose place it will take. Throws IoError.
  explicit TemporaryFile(const std::string& path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }  // write here; stays open until the destructor
  const std::string& name() const { return name_; }

  // All that was written is on the disk and then, at once, at `path`, with the mode and the owner of the file
  // that was there before, as far as this process may give it away. Throws IoError.
  void take_place();

 private:
  std::string path_, folder_, name_;
  int descriptor_ = -1;
  int slot_ = -1;  // where the signal handler finds the name
};

}  // namespace strad
