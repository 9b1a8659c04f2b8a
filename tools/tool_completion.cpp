#include "tool_completion.h"

#include <algorithm>

#include "tool_options.h"

namespace strad {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

// "half float" of the value "half|float".
std::string words_of(const CompletedOption& option) {
  std::string words = option.value;
  std::replace(words.begin(), words.end(), '|', ' ');
  return words;
}

// A shell function's name holds no dash in POSIX.
std::string function_name(std::string tool) {
  std::replace(tool.begin(), tool.end(), '-', '_');
  return "_" + tool;
}

// What follows an option that takes a value. Without words, bash offers files, by `-o default`.
std::string bash_case(const CompletedOption& option) {
  if (option.takes == OptionValue::kNone) return "";
  const std::string pattern = "    " + joined(option.names, "|") + ") ";
  if (option.takes == OptionValue::kWord)
    return pattern + "COMPREPLY=($(compgen -W '" + words_of(option) + "' -- \"$word\")); return ;;\n";
  if (option.takes == OptionValue::kPath) return pattern + "return ;;\n";
  return pattern + "compopt +o default; return ;;\n";
}

// `text` inside of single quotes, where _arguments gives brackets and colons a meaning.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_value(const CompletedOption& option) {
  const std::string name = ":" + zsh_text(option.value) + ":";
  if (option.takes == OptionValue::kNone) return "";
  if (option.takes == OptionValue::kWord) return ":value:(" + words_of(option) + ")";
  return name + (option.takes == OptionValue::kPath ? "_files" : "");
}

// A line for each name; one name excludes the others, unless the option may come again.
std::string zsh_lines(const CompletedOption& option) {
  std::string lines;
  for (const std::string& name : option.names) {
    const std::string once = option.repeatable ? "*" : "(" + joined(option.names, " ") + ")";
    const std::string joins = option.takes == OptionValue::kNone ? "" : name.starts_with("--") ? "=" : "+";
    lines += "  '" + once + name + joins + "[" + zsh_text(option.help) + "]" + zsh_value(option) + "' \\\n";
  }
  return lines;
}

std::string bash_completion(const std::string& tool, const std::vector<CompletedOption>& options) {
  std::vector<std::string> names;
  std::string cases;
  for (const CompletedOption& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    cases += bash_case(option);
  }
  // bash cuts --option=value into three words.
  return "# bash completion for " + tool + ", printed by " + tool + " --completion bash.\n" +
         function_name(tool) + "() {\n" +
         "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  if [[ $word == = ]]; then\n"
         "    word=\n"
         "  elif [[ $before == = ]]; then\n"
         "    before=${COMP_WORDS[COMP_CWORD - 2]}\n"
         "  fi\n"
         "  COMPREPLY=()\n"
         "  case $before in\n" +
         cases +
         "  esac\n"
         "  [[ $word != -* ]] || COMPREPLY=($(compgen -W '" +
         joined(names, " ") + "' -- \"$word\"))\n}\n" + "complete -o default -F " + function_name(tool) +
         " " + tool + "\n";
}

std::string zsh_completion(const std::string& tool, const std::vector<CompletedOption>& options) {
  std::string lines;
  for (const CompletedOption& option : options) lines += zsh_lines(option);
  return "#compdef " + tool + "\n# Printed by " + tool + " --completion zsh.\n_arguments -s \\\n" + lines +
         "  '*:file:_files'\n";
}

}  // namespace

std::string completion_for(const std::string& shell, const std::string& tool,
                           const std::vector<CompletedOption>& options) {
  if (shell == "bash") return bash_completion(tool, options);
  if (shell != "zsh") fail_option("--completion", shell, "bash or zsh");
  return zsh_completion(tool, options);
}

}  // namespace strad
