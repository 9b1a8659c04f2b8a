#include "base/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "base/error.h"

namespace strad {
namespace {

constexpr int kPatience = 10'000;  // ms; a shell opens both ends of a pipe at once

// Whether a program has the other end of a pipe open, without taking anything out of it: tee() copies what is
// there, ends (0) without a writer, and would wait (EAGAIN) for one that is silent.
bool is_held_open(int descriptor) {
  int scratch[2];
  if (::pipe2(scratch, O_CLOEXEC) != 0) return true;
  const ssize_t copied = ::tee(descriptor, scratch[1], 1, SPLICE_F_NONBLOCK);
  ::close(scratch[0]);
  ::close(scratch[1]);
  return copied != 0;
}

// poll() ends with data, or with the end of a writer that came and went.
bool has_writer(int descriptor) {
  pollfd waited{descriptor, POLLIN, 0};
  int answer = -1;
  do {
    answer = ::poll(&waited, 1, kPatience);
  } while (answer < 0 && errno == EINTR);
  return answer > 0 || is_held_open(descriptor);
}

}  // namespace

bool file_exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

bool is_plain_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

int open_for_reading(const std::string& path, const std::string& expected) {
  const auto failure = [&path] { return IoError(path + ": cannot be opened: " + std::strerror(errno)); };
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) throw failure();
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    const IoError error = failure();
    ::close(descriptor);
    throw error;
  }
  std::string fault;
  if (S_ISDIR(status.st_mode)) fault = "is a directory";
  if (S_ISFIFO(status.st_mode) && !has_writer(descriptor)) fault = "is a pipe that no program writes";
  if (!fault.empty()) {
    ::close(descriptor);
    throw BadInput(path + ": " + fault + ", expected " + expected);
  }
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return descriptor;
}

void read_blocks(const std::string& path, const std::string& expected,
                 const std::function<void(std::string_view block)>& see) {
  struct Closed {
    int descriptor;
    ~Closed() {
      if (descriptor != STDIN_FILENO) ::close(descriptor);
    }
  };
  const bool is_input = path == "-";
  const Closed file{is_input ? STDIN_FILENO : open_for_reading(path, expected)};
  std::vector<char> block(1 << 16);
  for (;;) {
    const ssize_t got = ::read(file.descriptor, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      throw IoError((is_input ? "standard input" : path) + ": cannot be read: " + std::strerror(errno));
    if (got == 0) return;
    see({block.data(), static_cast<size_t>(got)});
  }
}

}  // namespace strad
