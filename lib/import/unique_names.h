// Makes names unique.
#pragma once

#include <map>
#include <string>

namespace strad {

class UniqueNames {
 public:
  // `name` at its first use; then `name` with a number behind it: lamp, lamp_2, lamp_3.
  std::string unique(const std::string& name) {
    const int use = ++uses_[name];
    return use == 1 ? name : name + "_" + std::to_string(use);
  }

 private:
  std::map<std::string, int> uses_;
};

}  // namespace strad
