// Mapped files and pipes.
#include "stream/source.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "base/error.h"

namespace strad {
namespace {

constexpr size_t kReadStep =
    1 << 20;  // a pipe's buffer grows by this much at a time, whatever length is claimed

bool is_standard_input(const std::string& path) { return path.empty() || path == "-"; }

std::string fault_of(const std::string& name, const char* deed) {
  return name + ": cannot be " + deed + ": " + std::strerror(errno);
}

}  // namespace

Source::Source(const std::string& path) : name_(is_standard_input(path) ? "standard input" : path) {
  descriptor_ = is_standard_input(path) ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw IoError(fault_of(name_, "opened"));
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) throw IoError(fault_of(name_, "examined"));
  if (S_ISDIR(status.st_mode)) throw BadInput(name_ + ": found a folder, expected a stream");
  // Part of standard input may have been read before: the stream begins at the current position.
  pipe_ = !S_ISREG(status.st_mode) || ::lseek(descriptor_, 0, SEEK_CUR) != 0;
  if (pipe_ || status.st_size == 0) return;
  const size_t size = static_cast<size_t>(status.st_size);
  mapping_ = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor_, 0);
  if (mapping_ == MAP_FAILED) {
    mapping_ = nullptr;
    throw IoError(fault_of(name_, "mapped"));
  }
  bytes_ = {static_cast<const uint8_t*>(mapping_), size};
}

Source::Source(ByteSpan bytes, std::string name) : name_(std::move(name)), bytes_(bytes) {}

Source::~Source() {
  if (mapping_) ::munmap(mapping_, bytes_.size());
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
}

void Source::fill(uint64_t end) {
  while (!ended_ && read_.size() < end) {
    const size_t have = read_.size();
    if (read_.capacity() < have + kReadStep) read_.reserve(2 * have + kReadStep);
    read_.resize(have + kReadStep);
    const ssize_t got = ::read(descriptor_, read_.data() + have, kReadStep);
    read_.resize(have + static_cast<size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0 && errno != EINTR) throw IoError(fault_of(name_, "read"));
    ended_ = got == 0;
  }
  bytes_ = read_;
}

ByteSpan Source::at(uint64_t offset, uint64_t length) {
  const uint64_t end = offset + length < offset ? UINT64_MAX : offset + length;
  if (pipe_) fill(end);
  if (end > bytes_.size())
    throw BadInput(name_ + ": byte " + std::to_string(bytes_.size()) + ": the stream ends, expected " +
                   std::to_string(end - bytes_.size()) + " bytes more");
  return bytes_.subspan(offset, length);
}

bool Source::ends_at(uint64_t offset) {
  if (pipe_) fill(offset + 1);
  return bytes_.size() <= offset;
}

}  // namespace strad
