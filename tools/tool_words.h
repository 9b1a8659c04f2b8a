// The words of a command line: numbers, read strictly, and the line as it is recorded.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace strad {

// Plain decimal numbers, all of the text, finite: no `nan`, no octal, no units. Throw BadInput "WHAT: ...".
double parse_number(std::string_view text, const std::string& what);
int parse_integer(std::string_view text, const std::string& what);
// "1,2,3" with any number of parts, each a number.
std::vector<double> parse_numbers(std::string_view text, char separator, const std::string& what);
std::vector<int> parse_integers(std::string_view text, char separator, const std::string& what);
// A number, or two with a slash between, the second above 0: 24000/1001.
double parse_ratio(std::string_view text, const std::string& what);
// Exactly three: "X,Y,Z" or "R,G,B".
std::array<double, 3> parse_triple(std::string_view text, const std::string& what);
std::vector<std::string> split(std::string_view text, char separator);

[[noreturn]] void fail_option(const std::string& what, std::string_view found, const std::string& expected);

// An option that does not change the result, such as -j, and is left out of the record.
struct Unrecorded {
  std::string name;
  bool has_value;
};
// The arguments as typed, each after a space, quoted where a shell would need it.
std::string recorded_arguments(int argc, char** argv, const std::vector<Unrecorded>& unrecorded);

}  // namespace strad
