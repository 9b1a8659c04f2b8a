// Scripts that let shells complete a tool's options, made from the options themselves.
#pragma once

#include <string>
#include <vector>

namespace strad {

enum class OptionValue { kNone, kWord, kPath, kOther };

struct CompletedOption {
  std::vector<std::string> names;  // with their dashes: "-f", "--frames"
  std::string value;               // its name in the help, such as "LIST"; of words, "half|float"
  std::string help;
  OptionValue takes = OptionValue::kNone;
  bool repeatable = false;
};

// A script for a folder of bash-completion, or for one of zsh's `fpath`. Words that are not options are names
// of files. Throws BadInput for other shells.
std::string completion_for(const std::string& shell, const std::string& tool,
                           const std::vector<CompletedOption>& options);

}  // namespace strad
