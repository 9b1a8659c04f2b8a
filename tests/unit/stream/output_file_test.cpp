// Output files are complete or absent, whatever ends the program, and take the place of what was there.
#include "stream/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "test_folder.h"

namespace strad {
namespace {

namespace fs = std::filesystem;

class OutputTest : public TestFolder {
 protected:
  mode_t mode_of(const std::string& name) const {
    struct stat status {};
    EXPECT_EQ(::stat(path(name).c_str(), &status), 0);
    return status.st_mode & 07777;
  }
  void write(const std::string& name, const std::string& text) const { write_text_file(path(name), text); }
};

// The name of a temporary file: 22 letters of any kind.
const std::string kLeft = ".strad-0123456789abcdefABCDEF.tmp";

TEST_F(OutputTest, AFileAppearsWhole) {
  Output output(path("a"));
  output.write("hello");
  EXPECT_FALSE(fs::exists(path("a")));
  output.commit();
  EXPECT_EQ(content(path("a")), "hello");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputTest, AFailureLeavesWhatWasThere) {
  std::ofstream(path("a")) << "old";
  {
    Output output(path("a"));
    output.write("new");
  }
  EXPECT_EQ(content(path("a")), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputTest, ALinkStaysALink) {
  std::ofstream(path("target")) << "old";
  fs::create_symlink(path("target"), path("link"));
  Output output(path("link"));
  output.write("new");
  output.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(content(path("target")), "new");
}

TEST_F(OutputTest, WhatIsNoPlainFileIsWrittenInPlace) {
  Output output("/dev/null");
  output.write("gone");
  output.commit();
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(OutputTest, AnAbsentFolderIsTold) { EXPECT_THROW(Output(path("absent/a")), IoError); }

TEST_F(OutputTest, ASignalRemovesTheTemporaryFile) {
  EXPECT_EXIT(
      {
        Output output(path("a"));
        output.write("half");
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
  EXPECT_EQ(entries(), 0u);
}

TEST_F(OutputTest, ALinkToNothingIsWrittenThrough) {
  fs::create_directory(path("d"));
  fs::create_symlink("d/second", path("first"));  // from one folder to another, by relative names
  fs::create_symlink("target", path("d/second"));
  write("first", "new");
  EXPECT_TRUE(fs::is_symlink(path("first")));
  EXPECT_TRUE(fs::is_symlink(path("d/second")));
  EXPECT_EQ(content(path("d/target")), "new");

  fs::create_symlink("loop", path("loop"));
  EXPECT_THROW(Output(path("loop")), IoError);
}

TEST_F(OutputTest, TheModeOfAFileStays) {
  for (const mode_t mode : {0600, 0640, 0444, 0755}) {
    if (!(mode & S_IWUSR) && ::geteuid() != 0) continue;
    std::ofstream(path("a")) << "old";
    ASSERT_EQ(::chmod(path("a").c_str(), mode), 0);
    write("a", "new");
    EXPECT_EQ(content(path("a")), "new");
    EXPECT_EQ(mode_of("a"), mode);
    fs::remove(path("a"));
  }
}

TEST_F(OutputTest, ANewFileHasTheModeOfTheUmask) {
  const mode_t before = ::umask(027);
  write("a", "new");
  ::umask(before);
  EXPECT_EQ(mode_of("a"), 0640u);
}

TEST_F(OutputTest, AFileThatIsProtectedStays) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::ofstream(path("a")) << "old";
  ASSERT_EQ(::chmod(path("a").c_str(), 0444), 0);
  EXPECT_THROW(Output(path("a")), IoError);
  EXPECT_EQ(content(path("a")), "old");
}

TEST_F(OutputTest, NamesOfTemporaryFilesAreNeverTheSame) {
  const TemporaryFile a(path("a")), b(path("a"));
  EXPECT_NE(a.name(), b.name());
  EXPECT_EQ(fs::path(a.name()).parent_path(), folder_);
  EXPECT_EQ(fs::path(a.name()).filename().string().size(), kLeft.size());
}

TEST_F(OutputTest, WhatADeadProgramLeftIsRemoved) {
  std::ofstream(path(kLeft)) << "half";
  write("a", "new");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputTest, WhatAProgramStillWritesIsLeft) {
  const TemporaryFile mine(path("a"));
  EXPECT_EXIT(
      {
        write("b", "new");  // another program, which has not cleared this folder yet
        ::_exit(fs::exists(mine.name()) ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST_F(OutputTest, WhatOnlyLooksLikeATemporaryFileIsLeft) {
  std::ofstream(path(".strad-notes.tmp")) << "mine";
  std::ofstream(path("0" + kLeft)) << "mine";
  std::ofstream(path("target")) << "mine";
  fs::create_symlink("target", path(kLeft));
  std::string folder = kLeft;
  folder[10] = 'x';
  fs::create_directory(path(folder));
  write("a", "new");
  EXPECT_EQ(entries(), 6u);
}

TEST_F(OutputTest, EverySignalThatEndsAProgramRemovesTheTemporaryFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGXFSZ}) {
    EXPECT_EXIT(
        {
          Output output(path("a"));
          output.write("half");
          std::raise(signal);
        },
        testing::KilledBySignal(signal), "");
    EXPECT_EQ(entries(), 0u) << signal;
  }
}

TEST_F(OutputTest, TheNextRunClearsWhatAKilledOneLeft) {
  EXPECT_EXIT(
      {
        Output output(path("a"));
        output.write("half");
        std::raise(SIGKILL);
      },
      testing::KilledBySignal(SIGKILL), "");
  EXPECT_EQ(entries(), 1u);
  write("a", "new");
  EXPECT_EQ(entries(), 1u);
  EXPECT_EQ(content(path("a")), "new");
}

}  // namespace
}  // namespace strad
