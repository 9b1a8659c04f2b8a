// Options of a command line, read strictly. An error ends the tool with one line and exit status 2.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tool_words.h"

namespace strad {

// Options that tools share. -o and -j exist only where they are declared.
struct Common {
  bool quiet = false;    // -q, --quiet: no progress, no notes
  bool verbose = false;  // -v, --verbose
  std::string output;    // -o, --output FILE; "" or "-": standard output
  int jobs = 0;          // -j, --jobs N; 0: all cores
};

// Options are declared, then parsed. `names`: such as "-e,--error". `value`: the name of the value in the
// help, such as "E". If an option is absent, its variable keeps its value. If an option is given several
// times, the last one counts; lists take all.
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
  void path(const std::string& names, const std::string& value, std::string* variable,
            const std::string& help);  // a text that names a file
  void number(const std::string& names, const std::string& value, double* variable, const std::string& help);
  void number(const std::string& names, const std::string& value, std::optional<double>* variable,
              const std::string& help);
  void integer(const std::string& names, const std::string& value, int* variable, const std::string& help);
  void integer(const std::string& names, const std::string& value, std::optional<int>* variable,
               const std::string& help);
  // The value must be one of `words`.
  void choice(const std::string& names, const std::vector<std::string>& words, std::string* variable,
              const std::string& help);

  // Arguments without a dash, in order of declaration. Optional unless `required`.
  void file(const std::string& value, std::string* variable, const std::string& help, bool required = false);
  void files(const std::string& value, std::vector<std::string>* variable, const std::string& help,
             bool required = false);

  // Leaves an option out of the provenance, because it does not change the result. -j, -o, -q and -v are left
  // out anyway.
  void unrecorded(const std::string& name, bool has_value);

  // Throws BadInput. --help and --version print and throw Finished, which run_tool turns into exit status 0;
  // so does `--completion bash|zsh` alone, which the build runs (strad(7)). Sets the number of threads when
  // -j was declared.
  void parse(int argc, char** argv);

  // "strad-x VERSION arguments as typed".
  const std::string& provenance() const;
  std::string software() const;  // "strad-x VERSION"

 private:
  struct State;
  void apply_common();  // what was given, or BadInput

  Common* common_;
  std::unique_ptr<State> state_;
};

// Thrown after --help and --version: nothing is left to do.
struct Finished {};

}  // namespace strad
