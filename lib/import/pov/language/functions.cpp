// POV-Ray's functions of numbers, vectors and strings.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/pose.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"
#include "import/pov/language/noise.h"
#include "import/pov/language/number_functions.h"

namespace strad {
namespace {

constexpr size_t kLongestString = 1 << 16;

// Functions of objects, which the interpreter's user evaluates.
bool is_measure(std::string_view name) {
  return is_one_of(name, {"min_extent", "max_extent", "trace", "inside"});
}

Vec3 vector_of(const PovNumbers& n) { return n.size == 1 ? Vec3{n[0], n[0], n[0]} : Vec3{n[0], n[1], n[2]}; }
PovNumbers numbers_of(Vec3 v) {
  PovNumbers n;
  n.size = 3;
  n.parts = {v.x, v.y, v.z};
  return n;
}

// Turns about x, then y, then z. POV-Ray's space is left-handed and its turns are too, so the coordinates are
// those of counter-clockwise turns in a right-handed space.
Vec3 turned(Vec3 v, Vec3 degrees) {
  v = rotate(rotation_about({1, 0, 0}, degrees.x * kDegree), v);
  v = rotate(rotation_about({0, 1, 0}, degrees.y * kDegree), v);
  return rotate(rotation_about({0, 0, 1}, degrees.z * kDegree), v);
}

// `value` with `digits` digits after the point, padded to `width` with blanks, or with zeros if it is
// negative.
std::string written(double value, int width, int digits) {
  std::array<char, 400> text;
  const char* format = digits < 0 ? (width < 0 ? "%0*f" : "%*f") : (width < 0 ? "%0*.*f" : "%*.*f");
  const int filled = std::clamp(std::abs(width), 0, 60), shown = std::clamp(digits, 0, 30);
  const int size = digits < 0 ? std::snprintf(text.data(), text.size(), format, filled, value)
                              : std::snprintf(text.data(), text.size(), format, filled, shown, value);
  return std::string(text.data(), static_cast<size_t>(size));
}

}  // namespace

bool PovInterpreter::is_function(std::string_view name) const {
  return pov_number_function(name) ||
         is_one_of(name, {"vlength", "vdot", "vcross", "vnormalize", "vrotate", "vaxis_rotate", "vturbulence",
                          "seed", "rand", "strlen", "val", "asc", "defined", "dimension_size", "dimensions",
                          "strcmp", "file_exists"}) ||
         is_measure(name);
}

bool PovInterpreter::is_string_function(std::string_view name) const {
  return is_one_of(name, {"concat", "str", "chr", "substr", "strupr", "strlwr", "vstr"});
}

std::vector<PovNumbers> PovInterpreter::arguments(size_t least, size_t most) {
  expect("(");
  std::vector<PovNumbers> found{logical()};
  while (take_if(",")) found.push_back(logical());
  expect(")");
  if (found.size() < least || found.size() > most)
    fail("a function has " + std::to_string(found.size()) + " arguments");
  return found;
}

PovNumbers PovInterpreter::function(const std::string& name) {
  if (const PovNumberFunction* known = pov_number_function(name)) {
    std::vector<double> values;
    for (const PovNumbers& argument : arguments(known->least, known->most)) values.push_back(argument[0]);
    return finite_of(name, known->call(values));
  }
  return function_of_other_things(name);
}

PovNumbers PovInterpreter::finite_of(const std::string& function, double value) {
  if (!std::isfinite(value)) fail(function + " has no finite value here");
  return number_of(value);
}

// POV-Ray's own generator, so that scenes with random positions are the same as in POV-Ray.
double PovInterpreter::random(size_t stream) {
  if (stream >= random_states_.size()) fail("rand of a stream that seed did not make");
  random_states_[stream] = random_states_[stream] * 1812433253u + 12345u;
  return random_states_[stream] / 4294967295.0;
}

// vturbulence(lambda, omega, octaves, point)
PovNumbers PovInterpreter::turbulence() {
  note_noise();
  const std::vector<PovNumbers> a = arguments(4, 4);
  const double octaves = std::clamp(a[2][0], 0.0, 100.0);
  return numbers_of(turbulence_at(vector_of(a[3]), a[0][0], a[1][0], static_cast<int>(octaves)));
}

void PovInterpreter::note_noise() {
  report_->add("noise is alike POV-Ray's, not the same", here().file->name, raw().line);
}

PovNumbers PovInterpreter::function_of_other_things(const std::string& name) {
  if (name == "strlen" || name == "val" || name == "asc") {
    expect("(");
    const std::string text = string();
    expect(")");
    if (name == "strlen") return number_of(static_cast<double>(text.size()));
    if (name == "asc") return number_of(text.empty() ? 0 : static_cast<unsigned char>(text[0]));
    const auto found = number_in(text);
    if (!found) fail("val of " + in_quotes(text) + ", expected a number");
    return number_of(*found);
  }
  if (is_measure(name)) return statements_->measured(name);
  if (name == "strcmp" || name == "file_exists") {
    expect("(");
    const std::string first = string();
    double result = !found_include(first).empty();
    if (name == "strcmp") {
      expect(",");
      result = first.compare(string());
    }
    expect(")");
    return number_of(result);
  }
  if (name == "defined" || name == "dimensions" || name == "dimension_size") {
    expect("(");
    const std::string thing(take().text);
    const PovValue* known = find(thing);
    const auto* array = known ? std::get_if<std::shared_ptr<PovArray>>(known) : nullptr;
    double result = known != nullptr;
    if (open_files_.contains(thing)) result = !is_exhausted(thing);
    if (name != "defined") {
      if (!array) fail(name + " of what is not an array");
      const std::vector<size_t> sizes = (*array)->sizes;
      result = static_cast<double>(sizes.size());
      if (take_if(",")) {
        const int dimension = integer();
        if (dimension < 1 || dimension > static_cast<int>(sizes.size()))
          fail("the array has no such dimension");
        result = static_cast<double>(sizes[static_cast<size_t>(dimension - 1)]);
      }
    }
    expect(")");
    return number_of(result);
  }
  if (name == "vturbulence") return turbulence();
  const std::vector<PovNumbers> a = arguments(1, 3);
  const size_t wanted = name == "vaxis_rotate"                                    ? 3
                        : name == "vdot" || name == "vcross" || name == "vrotate" ? 2
                                                                                  : 1;
  if (a.size() != wanted)
    fail(name + " has " + std::to_string(a.size()) + " arguments, expected " + std::to_string(wanted));
  const Vec3 v = vector_of(a[0]);
  if (name == "vlength") return number_of(length(v));
  if (name == "vnormalize") return numbers_of(normalized(v));
  if (name == "vdot") return number_of(dot(v, vector_of(a[1])));
  if (name == "vcross") return numbers_of(cross(v, vector_of(a[1])));
  if (name == "vrotate") return numbers_of(turned(v, vector_of(a[1])));
  if (name == "vaxis_rotate")
    return numbers_of(rotate(rotation_about(normalized(vector_of(a[1])), a[2][0] * kDegree), v));
  if (!(std::abs(a[0][0]) < 1e18)) fail(name + " of a number that is too large");
  if (name == "rand") return number_of(random(static_cast<size_t>(std::max(0.0, a[0][0]))));
  random_states_.push_back(static_cast<uint32_t>(static_cast<int64_t>(a[0][0])));  // seed
  return number_of(static_cast<double>(random_states_.size() - 1));
}

std::string PovInterpreter::string_function(const std::string& name) {
  expect("(");
  std::string result;
  if (name == "str") {
    const double value = number();
    expect(",");
    const int width = integer();
    expect(",");
    result = written(value, width, integer());
  } else if (name == "vstr") {
    const int dimension = integer();
    expect(",");
    const PovNumbers values = numbers();
    expect(",");
    const std::string between = string();
    expect(",");
    const int width = integer();
    expect(",");
    const int digits = integer();
    for (int i = 0; i < std::min(dimension, 5); ++i)
      result += (i ? between : "") + written(values[i], width, digits);
  } else if (name == "chr") {
    result = static_cast<char>(integer());
  } else {
    result = string();
    while (name == "concat" && take_if(",")) {
      result += string();
      if (result.size() > kLongestString)
        fail("a string has more than " + std::to_string(kLongestString) + " characters");
    }
    if (name == "substr") {
      expect(",");
      const int first = integer();
      expect(",");
      const int count = integer();
      if (first < 1 || count < 0 || first - 1 + count > static_cast<int>(result.size()))
        fail("substr outside its string");
      result = result.substr(static_cast<size_t>(first - 1), static_cast<size_t>(count));
    }
    if (name == "strupr") std::transform(result.begin(), result.end(), result.begin(), ::toupper);
    if (name == "strlwr") std::transform(result.begin(), result.end(), result.begin(), ::tolower);
  }
  expect(")");
  charge(result.size());
  return result;
}

}  // namespace strad
