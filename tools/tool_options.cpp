// Options of a command line. The only user of CLI11, which finds the options; their values are parsed here.
#include "tool_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

#include "base/error.h"
#include "base/likeness.h"
#include "tool_completion.h"

namespace strad {

struct Options::State {
  CLI::App app;
  std::string tool;
  std::vector<Unrecorded> unrecorded;
  std::string provenance;
  std::map<const CLI::Option*, OptionValue> takes;  // the others take what has no names

  State(const std::string& name, const std::string& about) : app(about, name), tool(name) {}

  // What is wrong with the words that are left over. An unknown option is named, not the file names beside
  // it.
  std::string fault_of_extras() const {
    const std::vector<std::string> extras = app.remaining();
    for (const std::string& extra : extras) {
      if (!extra.starts_with('-') || extra == "-") continue;
      const std::string typed = extra.substr(0, extra.find('='));
      std::vector<std::string> names;
      for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
      return "found the unknown option " + typed + did_you_mean(typed, names);
    }
    return "found '" + (extras.empty() ? "" : extras.front()) + "', expected no more file names";
  }

  using Take = std::function<void(const std::string&)>;

  CLI::Option* add(const std::string& names, const std::string& value, const std::string& help,
                   bool repeatable, Take take) {
    CLI::Option* option = app.add_option(
        names,
        [take = std::move(take)](const CLI::results_t& results) {
          for (const std::string& result : results) take(result);
          return true;
        },
        help);
    option->type_name(value)->expected(1)->allow_extra_args(false);
    option->multi_option_policy(repeatable ? CLI::MultiOptionPolicy::TakeAll
                                           : CLI::MultiOptionPolicy::TakeLast);
    return option;
  }

  CompletedOption completed(const CLI::Option& option) const {
    CompletedOption result;
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
    result.help = option.get_description();
    result.repeatable = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (option.get_items_expected_max() == 0) return result;
    result.value = option.get_type_name();
    const auto found = takes.find(&option);
    result.takes = found == takes.end() ? OptionValue::kOther : found->second;
    return result;
  }

  void print_completion(const std::string& shell) const {
    std::vector<CompletedOption> options;
    for (const CLI::Option* option : app.get_options())
      if (!option->get_positional()) options.push_back(completed(*option));
    std::cout << completion_for(shell, tool, options);
  }
};

Options::Options(const std::string& tool, const std::string& about, Common* common)
    : common_(common), state_(std::make_unique<State>(tool, about)) {
  CLI::App& app = state_->app;
  app.set_help_flag("-h,--help", "print this help and exit");
  app.set_version_flag("--version", tool + " " STRAD_VERSION, "print the version and exit");
  app.get_formatter()->column_width(34);
  app.add_flag("-q,--quiet", common->quiet, "no progress and no notes on standard error");
  app.add_flag("-v,--verbose", common->verbose, "more notes on standard error");
  for (const char* name : {"-q", "--quiet", "-v", "--verbose"}) unrecorded(name, false);
}

Options::~Options() = default;

void Options::flag(const std::string& names, bool* variable, const std::string& help) {
  state_->app.add_flag(names, *variable, help);
}

void Options::text(const std::string& names, const std::string& value, std::string* variable,
                   const std::string& help) {
  state_->add(names, value, help, false, [=](const std::string& word) { *variable = word; });
}

void Options::texts(const std::string& names, const std::string& value, std::vector<std::string>* variable,
                    const std::string& help) {
  state_->add(names, value, help, true, [=](const std::string& word) { variable->push_back(word); });
}

void Options::path(const std::string& names, const std::string& value, std::string* variable,
                   const std::string& help) {
  const auto take = [=](const std::string& word) { *variable = word; };
  state_->takes[state_->add(names, value, help, false, take)] = OptionValue::kPath;
}

void Options::number(const std::string& names, const std::string& value, double* variable,
                     const std::string& help) {
  state_->add(names, value, help, false,
              [=](const std::string& word) { *variable = parse_number(word, names); });
}

void Options::number(const std::string& names, const std::string& value, std::optional<double>* variable,
                     const std::string& help) {
  state_->add(names, value, help, false,
              [=](const std::string& word) { *variable = parse_number(word, names); });
}

void Options::integer(const std::string& names, const std::string& value, int* variable,
                      const std::string& help) {
  state_->add(names, value, help, false,
              [=](const std::string& word) { *variable = parse_integer(word, names); });
}

void Options::integer(const std::string& names, const std::string& value, std::optional<int>* variable,
                      const std::string& help) {
  state_->add(names, value, help, false,
              [=](const std::string& word) { *variable = parse_integer(word, names); });
}

void Options::choice(const std::string& names, const std::vector<std::string>& words, std::string* variable,
                     const std::string& help) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : "|") + word;
  const CLI::Option* option = state_->add(names, list, help, false, [=](const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) fail_option(names, word, list);
    *variable = word;
  });
  state_->takes[option] = OptionValue::kWord;
}

void Options::file(const std::string& value, std::string* variable, const std::string& help, bool required) {
  state_->add(value, "", help, false, [=](const std::string& word) { *variable = word; })->required(required);
}

void Options::files(const std::string& value, std::vector<std::string>* variable, const std::string& help,
                    bool required) {
  state_->add(value, "", help, true, [=](const std::string& word) { variable->push_back(word); })
      ->expected(required ? 1 : 0, CLI::detail::expected_max_vector_size)
      ->allow_extra_args(true)
      ->required(required);
}

void Options::unrecorded(const std::string& name, bool has_value) {
  state_->unrecorded.push_back({name, has_value});
}

void Options::parse(int argc, char** argv) {
  if (argc == 3 && argv[1] == std::string_view("--completion")) {
    state_->print_completion(argv[2]);
    throw Finished{};
  }
  state_->provenance = software() + recorded_arguments(argc, argv, state_->unrecorded);
  try {
    state_->app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    std::cout << state_->app.help() << std::flush;
    throw Finished{};
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << std::endl;
    throw Finished{};
  } catch (const CLI::ExtrasError&) {
    throw BadInput(state_->fault_of_extras() + "; see " + state_->tool + " --help");
  } catch (const CLI::ParseError& error) {
    throw BadInput(std::string(error.what()) + "; see " + state_->tool + " --help");
  }
  apply_common();
}

const std::string& Options::provenance() const { return state_->provenance; }
std::string Options::software() const { return state_->tool + " " STRAD_VERSION; }

}  // namespace strad
