// The bytes of a stream: a mapped file, or a pipe that is read as far as needed.
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
  uint64_t size() const { return bytes_.size(); }  // REQUIRES: seekable()

  // The `length` bytes at `offset`; valid until the next call. Throws BadInput when the stream ends before.
  ByteSpan at(uint64_t offset, uint64_t length);
  bool ends_at(uint64_t offset);

 private:
  void fill(uint64_t end);

  std::string name_;
  ByteSpan bytes_;
  Bytes read_;  // what came from a pipe so far
  bool pipe_ = false;
  bool ended_ = false;
  int descriptor_ = -1;
  void* mapping_ = nullptr;
};

}  // namespace strad
