// Options of a command line, strictly read. Errors become one line and exit status 2.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tool_words.h"

namespace strad {

// What every tool has. `--help` and `--version` are there for all; the rest where asked for.
struct Common {
  bool quiet = false;    // -q, --quiet: no progress, no notes
  bool verbose = false;  // -v, --verbose
  std::string output;    // -o, --output FILE; "" or "-": standard output
  int jobs = 0;          // -j, --jobs N; 0: all cores
};

// Declares options, then parses. `names` as "-e,--error"; `value` names the value in the help, as "E". The
// variable keeps its default when the option is absent; the last of a repeated option wins, lists gather all.
class Options {
 public:
  // Adds -h, --version, -q and -v. `about`: one sentence.
  Options(const std::string& tool, const std::string& about, Common* common);
  ~Options();

  void output(const std::string& help = "write to FILE instead of standard output");  // adds -o
  void jobs();                                                                        // adds -j

  void flag(const std::string& names, bool* variable, const std::string& help);
  void text(const std::string& names, const std::string& value, std::string* variable,
            const std::string& help);
  void texts(const std::string& names, const std::string& value, std::vector<std::string>* variable,
             const std::string& help);  // repeatable, one value each
  void number(const std::string& names, const std::string& value, double* variable, const std::string& help);
  void number(const std::string& names, const std::string& value, std::optional<double>* variable,
              const std::string& help);
  void integer(const std::string& names, const std::string& value, int* variable, const std::string& help);
  void integer(const std::string& names, const std::string& value, std::optional<int>* variable,
               const std::string& help);
  // One of `words`.
  void choice(const std::string& names, const std::vector<std::string>& words, std::string* variable,
              const std::string& help);

  // Arguments without a dash, in order of declaration. Optional unless `required`.
  void file(const std::string& value, std::string* variable, const std::string& help, bool required = false);
  void files(const std::string& value, std::vector<std::string>* variable, const std::string& help,
             bool required = false);

  // The option does not touch the result: it is left out of the provenance, as -j, -o, -q and -v are.
  void unrecorded(const std::string& name, bool has_value);

  // Throws BadInput. --help and --version print and throw Finished, which run_tool turns into exit status 0.
  // Sets the number of threads when -j was declared.
  void parse(int argc, char** argv);

  // "strad-x VERSION arguments as typed".
  const std::string& provenance() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Thrown where nothing is left to do.
struct Finished {};

}  // namespace strad
