// Files and pipes.
#include "stream/source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/files.h"

namespace strad {
namespace {

constexpr size_t kReadStep =
    1 << 20;  // the buffer grows by no more than this or twice, whatever length is claimed

bool is_standard_input(const std::string& path) { return path.empty() || path == "-"; }

std::string fault_of(const std::string& name, const char* deed) {
  return name + ": cannot be " + deed + ": " + std::strerror(errno);
}

}  // namespace

// Files are read, not mapped: memory of a mapping is gone, with SIGBUS, when another program cuts the file.
Source::Source(const std::string& path) : name_(is_standard_input(path) ? "standard input" : path) {
  descriptor_ = is_standard_input(path) ? STDIN_FILENO : open_for_reading(path, "a stream");
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) throw IoError(fault_of(name_, "examined"));
  if (S_ISDIR(status.st_mode)) throw BadInput(name_ + ": is a directory, expected a stream");
  // Part of standard input may have been read before: the stream begins at the current position.
  pipe_ = !S_ISREG(status.st_mode) || ::lseek(descriptor_, 0, SEEK_CUR) != 0;
  if (!pipe_) size_ = static_cast<uint64_t>(status.st_size);
}

Source::Source(ByteSpan bytes, std::string name)
    : name_(std::move(name)), memory_(bytes), size_(bytes.size()) {}

Source::~Source() {
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
}

size_t Source::read_more(size_t count, uint64_t offset) {
  const size_t have = read_.size();
  if (read_.capacity() < have + count) read_.reserve(std::max(2 * have, have + count));
  read_.resize(have + count);
  ssize_t got = -1;
  do {
    got = pipe_ ? ::read(descriptor_, read_.data() + have, count)
                : ::pread(descriptor_, read_.data() + have, count, static_cast<off_t>(offset));
  } while (got < 0 && errno == EINTR);
  if (got < 0) throw IoError(fault_of(name_, "read"));
  read_.resize(have + static_cast<size_t>(got));
  return static_cast<size_t>(got);
}

void Source::fill(uint64_t end) {
  while (!ended_ && read_.size() < end) ended_ = read_more(kReadStep, 0) == 0;
}

void Source::read_at(uint64_t offset, uint64_t length) {
  read_.clear();
  while (read_.size() < length) {
    const uint64_t left = length - read_.size();
    const size_t step = static_cast<size_t>(std::min<uint64_t>(left, std::max(kReadStep, read_.size())));
    if (read_more(step, offset + read_.size()) == 0) fail_ended(offset + read_.size(), offset + length);
  }
}

void Source::fail_ended(uint64_t size, uint64_t end) const {
  throw BadInput(name_ + ": byte " + std::to_string(size) + ": the stream ends, expected " +
                 std::to_string(end - size) + " bytes more");
}

ByteSpan Source::at(uint64_t offset, uint64_t length) {
  const uint64_t end = offset + length < offset ? UINT64_MAX : offset + length;
  if (pipe_) fill(end);
  const uint64_t size = pipe_ ? read_.size() : size_;
  if (end > size) fail_ended(size, end);
  if (pipe_) return ByteSpan(read_).subspan(offset, length);
  if (descriptor_ < 0) return memory_.subspan(offset, length);
  read_at(offset, length);
  return read_;
}

bool Source::ends_at(uint64_t offset) {
  if (!pipe_) return size_ <= offset;
  fill(offset + 1);
  return read_.size() <= offset;
}

}  // namespace strad
