// Files that are complete or absent.
#include "stream/output_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.h"

namespace strad {
namespace {

[[noreturn]] void fail(const std::string& name) {
  throw IoError(name + ": cannot be written: " + std::strerror(errno));
}

// The file that `path` stands for, which need not be there.
std::string resolved(const std::string& path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::filesystem::path file(path);
  for (int links = 0; links <= kMostLinks; ++links) {
    std::error_code error;
    const auto target = std::filesystem::read_symlink(file, error);
    if (error) return file.string();  // no link, or nothing there
    file = file.parent_path() / target;
  }
  errno = ELOOP;
  fail(path);
}

bool is_special(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

}  // namespace

Output::Output(const std::string& path) : name_(path) {
  if (path.empty() || path == "-") {
    name_ = "standard output";
    handle_ = stdout;
    return;
  }
  if (is_special(path)) {
    handle_ = std::fopen(path.c_str(), "wb");
  } else {
    file_ = std::make_unique<TemporaryFile>(resolved(path));
    handle_ = ::fdopen(::fcntl(file_->descriptor(), F_DUPFD_CLOEXEC, 0), "wb");
  }
  if (!handle_) fail(name_);
}

Output::~Output() {
  if (handle_ && handle_ != stdout) std::fclose(handle_);
}

bool Output::to_terminal() const { return ::isatty(::fileno(handle_)) == 1; }

void Output::write(ByteSpan bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), handle_) != bytes.size()) fail(name_);
}

void Output::write(const std::string& text) {
  write(ByteSpan(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

void Output::commit() {
  if (std::fflush(handle_) != 0) fail(name_);
  if (handle_ == stdout) return;
  const bool closed = std::fclose(handle_) == 0;
  handle_ = nullptr;
  if (!closed) fail(name_);
  if (file_) file_->take_place();
}

void write_text_file(const std::string& path, const std::string& text) {
  Output output(path);
  output.write(text);
  output.commit();
}

}  // namespace strad
