// Names of which each is given out once.
#pragma once

#include <map>
#include <string>

namespace strad {

class UniqueNames {
 public:
  // `name`, from its second use on with a number behind it.
  std::string unique(const std::string& name) {
    const int use = ++uses_[name];
    return use == 1 ? name : name + "_" + std::to_string(use);
  }

 private:
  std::map<std::string, int> uses_;
};

}  // namespace strad
