// The bytes of a stream: a file that is read where needed, or a pipe that is read as far as needed.
#pragma once

#include <cstdint>
#include <string>

#include "stream/bytes.h"

namespace strad {

class Source {
 public:
  // "" or "-": standard input. Throws IoError when it cannot be opened.
  explicit Source(const std::string& path);
  // Bytes in memory, for tests. Keeps the span.
  Source(ByteSpan bytes, std::string name);
  ~Source();
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  const std::string& name() const { return name_; }
  // Whether bytes at any offset can be read at once: true for files and memory, false for pipes.
  bool seekable() const { return !pipe_; }
  uint64_t size() const { return size_; }  // when it was opened. REQUIRES: seekable()

  // The `length` bytes at `offset`; valid until the next call. Throws BadInput when the stream ends before,
  // also because another program has cut the file meanwhile.
  ByteSpan at(uint64_t offset, uint64_t length);
  bool ends_at(uint64_t offset);

 private:
  void fill(uint64_t end);
  void read_at(uint64_t offset, uint64_t length);
  // Puts up to `count` more bytes behind `read_`; fewer, or none, at the end. `offset` is where a file is
  // read.
  size_t read_more(size_t count, uint64_t offset);
  [[noreturn]] void fail_ended(uint64_t size, uint64_t end) const;

  std::string name_;
  ByteSpan memory_;  // for tests
  Bytes read_;       // what came from a pipe so far, or the last bytes of a file that were asked for
  uint64_t size_ = 0;
  bool pipe_ = false;
  bool ended_ = false;
  int descriptor_ = -1;
};

}  // namespace strad
