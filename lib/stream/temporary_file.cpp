#include "stream/temporary_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>

#include "base/error.h"

namespace strad {
namespace {

constexpr const char* kPrefix = ".strad-";
constexpr const char* kSuffix = ".tmp";
constexpr size_t kLetters = 22;  // of 62: 131 bits
constexpr const char* kAlphabet = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

// Names to remove when a signal ends the program. Fixed memory, since a handler may not allocate; pages that
// are not used take none.
constexpr int kSlots = 1024;
constexpr size_t kLongestPath = 4096;
struct Slot {
  std::atomic<bool> used;
  char path[kLongestPath];
};
Slot slots[kSlots];
std::mutex mutex;  // of the slots, and of the folders that were cleared

void remove_and_die(int signal) {
  for (Slot& slot : slots)
    if (slot.used) ::unlink(slot.path);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

int remember(const std::string& path) {
  const std::lock_guard lock(mutex);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGXFSZ})
    if (std::signal(signal, remove_and_die) == SIG_IGN) std::signal(signal, SIG_IGN);
  for (int i = 0; i < kSlots && path.size() < kLongestPath; ++i) {
    if (slots[i].used) continue;
    std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
    slots[i].used = true;
    return i;
  }
  return -1;
}

void forget(int slot) {
  const std::lock_guard lock(mutex);
  if (slot >= 0) slots[slot].used = false;
}

[[noreturn]] void fail(const std::string& path) {
  throw IoError(path + ": cannot be written: " + std::strerror(errno));
}

// Letters that nobody can guess. A modulus of 62 favours some letters by a little, which 131 bits allow.
std::string random_name(const std::string& path) {
  unsigned char bytes[kLetters];
  if (::getrandom(bytes, sizeof bytes, 0) != static_cast<ssize_t>(sizeof bytes)) fail(path);
  std::string name = kPrefix;
  for (const unsigned char byte : bytes) name += kAlphabet[byte % 62];
  return name + kSuffix;
}

bool is_ours(const std::string& name) {
  const std::string prefix = kPrefix, suffix = kSuffix;
  if (name.size() != prefix.size() + kLetters + suffix.size()) return false;
  return name.starts_with(prefix) && name.ends_with(suffix) &&
         name.find_first_not_of(kAlphabet, prefix.size()) == prefix.size() + kLetters;
}

// Removes a temporary file whose program has ended: a program that lives holds the lock.
void clear_if_left(int folder, const char* name) {
  const int descriptor = ::openat(folder, name, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
      ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    ::unlinkat(folder, name, 0);
  ::close(descriptor);
}

// Once in the life of a program, for each folder.
void clear_folder(const std::string& folder) {
  static std::set<std::string> cleared;
  const std::lock_guard lock(mutex);
  if (!cleared.insert(folder).second) return;
  DIR* const entries = ::opendir(folder.c_str());
  if (!entries) return;
  while (const dirent* entry = ::readdir(entries))
    if (is_ours(entry->d_name)) clear_if_left(::dirfd(entries), entry->d_name);
  ::closedir(entries);
}

// To the disk, where the file system can do that.
bool synchronize(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS || errno == ENOSYS ||
         errno == EOPNOTSUPP;
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

TemporaryFile::TemporaryFile(const std::string& path) : path_(path), folder_(folder_of(path)) {
  struct stat status {};
  const bool replaces = ::stat(path.c_str(), &status) == 0;
  // A file that is protected from writing is not replaced, either.
  if (replaces && ::access(path.c_str(), W_OK) != 0) fail(path);
  clear_folder(folder_);
  // Nobody else may read it before it has the mode of the file it replaces.
  const mode_t mode = replaces ? S_IRUSR | S_IWUSR : 0666;
  for (;;) {
    name_ = folder_ + "/" + random_name(path);
    slot_ = remember(name_);
    descriptor_ = ::open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (descriptor_ < 0) {
      forget(slot_);
      fail(path);
    }
    // A program that clears the folder may have found it before it was locked.
    const bool locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK);
    if (locked && ::fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return;
    ::unlink(name_.c_str());
    ::close(descriptor_);
    forget(slot_);
  }
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) ::unlink(name_.c_str());
  forget(slot_);
  ::close(descriptor_);
}

void TemporaryFile::take_place() {
  struct stat old {};
  if (::stat(path_.c_str(), &old) == 0) {
    const bool given = ::fchown(descriptor_, old.st_uid, old.st_gid) == 0;
    struct stat now {};
    ::fstat(descriptor_, &now);
    // What the group may do is for the old group only.
    const mode_t mode = given || now.st_gid == old.st_gid ? old.st_mode & 0777 : old.st_mode & 0707;
    if (::fchmod(descriptor_, mode) != 0) fail(path_);
  }
  if (!synchronize(descriptor_)) fail(path_);
  if (::rename(name_.c_str(), path_.c_str()) != 0) fail(path_);
  name_.clear();
  const int folder = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  static_cast<void>(synchronize(folder));  // the file is whole, whether or not its name outlives a power cut
  ::close(folder);
}

}  // namespace strad
