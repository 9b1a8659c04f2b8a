// Files that are complete or absent.
#include "stream/output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "base/error.h"

namespace strad {
namespace {

// Temporary files to remove when a signal ends the program. Fixed memory, since a handler may not allocate.
constexpr int kSlots = 8;
constexpr size_t kLongestPath = 4096;
char temporary_files[kSlots][kLongestPath];

void remove_temporary_files(int signal) {
  for (const auto& path : temporary_files)
    if (path[0]) ::unlink(path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void remember(const std::string& path) {
  if (path.size() >= kLongestPath) return;
  for (auto& slot : temporary_files) {
    if (slot[0]) continue;
    std::memcpy(slot + 1, path.c_str() + 1, path.size());
    slot[0] = path[0];  // written last, so that a handler never sees half a name
    break;
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, remove_temporary_files) == SIG_IGN) std::signal(signal, SIG_IGN);
}

void forget(const std::string& path) {
  for (auto& slot : temporary_files)
    if (path == slot) slot[0] = 0;
}

[[noreturn]] void fail(const std::string& name, const char* deed) {
  throw IoError(name + ": cannot be " + deed + ": " + std::strerror(errno));
}

// The file that `path` stands for: symbolic links are followed, so that they stay.
std::string resolved(const std::string& path) {
  std::error_code error;
  const auto real = std::filesystem::canonical(path, error);
  return error ? path : real.string();
}

bool is_special(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

// A hidden file beside it. The extension is kept because image writers choose the format by it.
std::string beside(const std::string& path) {
  const std::filesystem::path full(path);
  return (full.parent_path() / ("." + std::to_string(::getpid()) + "." + full.filename().string())).string();
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : path_(resolved(path)), temporary_(path_) {
  if (is_special(path_)) return;
  temporary_ = beside(path_);
  remember(temporary_);
}

WholeFile::~WholeFile() {
  if (committed_ || temporary_ == path_) return;
  ::unlink(temporary_.c_str());
  forget(temporary_);
}

void WholeFile::commit() {
  if (temporary_ != path_) {
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, "written");
    forget(temporary_);
  }
  committed_ = true;
}

Output::Output(const std::string& path) : name_(path) {
  if (path.empty() || path == "-") {
    name_ = "standard output";
    handle_ = stdout;
    return;
  }
  file_ = std::make_unique<WholeFile>(path);
  handle_ = std::fopen(file_->temporary().c_str(), "wb");
  if (!handle_) fail(name_, "written");
}

Output::~Output() {
  if (handle_ && handle_ != stdout) std::fclose(handle_);
}

bool Output::to_terminal() const { return ::isatty(::fileno(handle_)) == 1; }

void Output::write(ByteSpan bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), handle_) != bytes.size()) fail(name_, "written");
}

void Output::write(const std::string& text) {
  write(ByteSpan(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
}

void Output::commit() {
  if (std::fflush(handle_) != 0) fail(name_, "written");
  if (handle_ == stdout) return;
  const bool closed = std::fclose(handle_) == 0;
  handle_ = nullptr;
  if (!closed) fail(name_, "written");
  file_->commit();
}

void write_text_file(const std::string& path, const std::string& text) {
  Output output(path);
  output.write(text);
  output.commit();
}

}  // namespace strad
