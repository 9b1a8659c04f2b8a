// Files of a test in a folder of their own, imported, and what is told of them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "import/import.h"
#include "import/obj/obj.h"
#include "import/pov/pov.h"

namespace strad {

class ImportFolder : public testing::Test {
 protected:
  ImportFolder() {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string(test->test_suite_name()) + "_" + test->name());
    std::filesystem::create_directories(folder_);
  }
  ~ImportFolder() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string without_folder(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (size_t at = text.find(prefix); at != text.npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }
  // What the import of `text` is refused with; "" if it is not.
  std::string refusal(const std::string& text) {
    try {
      import(text);
    } catch (const BadInput& error) {
      return without_folder(error.what());
    }
    return "";
  }
  virtual Scene import(const std::string& text) = 0;
  std::string note(size_t index) const {
    const std::vector<std::string> lines = report_.lines();
    return index < lines.size() ? without_folder(lines[index]) : "";
  }
  bool noted(const std::string& what) const {
    for (const std::string& line : report_.lines())
      if (line.find(what) != line.npos) return true;
    return false;
  }

  std::filesystem::path folder_;
  ImportOptions options_;
  ImportReport report_;
};

class ImportObjFolder : public ImportFolder {
 protected:
  Scene import(const std::string& text) override {
    write("room.obj", text);
    report_ = {};
    return import_obj(path("room.obj"), options_, &report_);
  }
};

class ImportPovFolder : public ImportFolder {
 protected:
  Scene import(const std::string& text) override {
    write("room.pov", text);
    report_ = {};
    return import_pov(path("room.pov"), options_, &report_);
  }
  // A right-handed camera: coordinates stay as they are.
  const std::string kKept = "camera { location <0, 0, 5> look_at 0 right <-1, 0, 0> }\n";
};

}  // namespace strad
