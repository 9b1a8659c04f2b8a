// POV-Ray's expressions: numbers and vectors.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/colours.h"
#include "import/pov/language/interpreter.h"

namespace strad {
namespace {

template <typename Operation>
PovNumbers by_parts(const PovNumbers& a, const PovNumbers& b, Operation operation) {
  const int size = std::max(a.size, b.size);
  const PovNumbers left = promoted(a, size), right = promoted(b, size);
  PovNumbers result;
  result.size = size;
  for (int i = 0; i < size; ++i) result[i] = operation(left[i], right[i]);
  return result;
}

}  // namespace

std::optional<PovNumbers> PovInterpreter::constant(std::string_view word) {
  if (const auto found = numbers_.find(word); found != numbers_.end()) return number_of(found->second);
  if (word.size() != 1) return {};
  const size_t axis = std::string_view("xyzt").find(word[0]);
  if (axis == std::string_view::npos && word != "u" && word != "v") return {};
  PovNumbers unit;
  unit.size = word == "t" ? 4 : word == "u" || word == "v" ? 2 : 3;
  unit[word == "u" ? 0 : word == "v" ? 1 : static_cast<int>(axis)] = 1;
  return unit;
}

bool PovInterpreter::expression_is_next() {
  const PovToken& token = peek();
  if (token.kind == PovKind::kNumber) return true;
  if (token.kind == PovKind::kSymbol) return is_one_of(token.text, {"<", "(", "-", "+", "!"});
  if (token.kind != PovKind::kWord) return false;
  if (const PovValue* sample = sample_of(find(token.text)))
    return std::holds_alternative<PovNumbers>(*sample) || is_callable(token.text);
  return constant(token.text) || starts_colour(token.text) || is_function(token.text);
}

PovNumbers PovInterpreter::numbers() {
  const PovToken& token = peek();
  if (token.kind == PovKind::kWord && starts_colour(token.text)) return colour_numbers();
  return sum();
}

double PovInterpreter::number() {
  const PovPlace at = place();
  const PovNumbers found = numbers();
  if (found.size != 1) fail_at(at.file, at.line, "found a vector, expected a number");
  return found[0];
}

int PovInterpreter::integer() {
  const PovPlace at = place();
  const double found = number();
  if (!(std::abs(found) < 1e9)) fail_at(at.file, at.line, "found a number that is too large");
  return static_cast<int>(std::lround(found));
}

bool PovInterpreter::truth() {
  expect("(");
  const bool result = logical()[0] != 0;
  expect(")");
  return result;
}

Vec3 PovInterpreter::vector() {
  const PovNumbers found = promoted(numbers(), 3);
  return {found[0], found[1], found[2]};
}

Vec2 PovInterpreter::vector2() {
  const PovNumbers found = promoted(numbers(), 2);
  return {found[0], found[1]};
}

PovNumbers PovInterpreter::logical() {
  PovNumbers left = comparison();
  while (next_is("&") || next_is("|")) {
    const bool both = take().text == "&";
    const PovNumbers right = comparison();
    left = number_of(both ? left[0] != 0 && right[0] != 0 : left[0] != 0 || right[0] != 0);
  }
  return left;
}

PovNumbers PovInterpreter::comparison() {
  if (string_is_next()) return compared_strings();
  PovNumbers left = numbers();
  while (peek().kind == PovKind::kSymbol && is_one_of(peek().text, {"<", ">", "<=", ">=", "=", "!="})) {
    const std::string_view sign = take().text;
    const double a = left[0], b = numbers()[0];
    left = number_of(sign == "<"    ? a < b
                     : sign == ">"  ? a > b
                     : sign == "<=" ? a <= b
                     : sign == ">=" ? a >= b
                     : sign == "="  ? a == b
                                    : a != b);
  }
  return left;
}

PovNumbers PovInterpreter::sum() {
  PovNumbers left = product();
  while (operator_is_next("+") || operator_is_next("-")) {
    const bool plus = take().text == "+";
    left = by_parts(left, product(), [plus](double a, double b) { return plus ? a + b : a - b; });
  }
  return left;
}

PovNumbers PovInterpreter::product() {
  PovNumbers left = unary();
  while (operator_is_next("*") || operator_is_next("/")) {
    const bool times = take().text == "*";
    const PovPlace at = place();
    const PovNumbers right = unary();
    if (!times &&
        std::any_of(right.parts.begin(), right.parts.begin() + right.size, [](double d) { return d == 0; }))
      fail_at(at.file, at.line, "division by 0");
    left = by_parts(left, right, [times](double a, double b) { return times ? a * b : a / b; });
  }
  return left;
}

PovNumbers PovInterpreter::unary() {
  std::string signs;
  while (next_is("+") || next_is("-") || next_is("!")) signs += take().text;
  PovNumbers found = postfix();
  for (auto sign = signs.rbegin(); sign != signs.rend(); ++sign) {
    if (*sign == '!') found = number_of(found[0] == 0);
    if (*sign == '-') found = by_parts(found, number_of(-1), [](double a, double b) { return a * b; });
  }
  return found;
}

PovNumbers PovInterpreter::postfix() {
  PovNumbers found = primary();
  while (operator_is_next(".")) {
    take();
    constexpr std::string_view kAxes = "xyzt";
    const PovToken token = take();
    const int of_colour = colour_part(token.text);
    size_t part = token.text.size() == 1     ? kAxes.find(token.text[0])
                  : of_colour < kColourParts ? of_colour
                                             : kAxes.npos;
    if (token.text == "u" || token.text == "v") part = token.text == "v";
    if (token.text == "gray") {
      found = number_of(0.297 * found[0] + 0.589 * found[1] + 0.114 * found[2]);
    } else {
      if (part >= kColourParts)
        fail("found ." + std::string(token.text) + ", expected a part such as .x or .red");
      found = number_of(found[static_cast<int>(part)]);
    }
  }
  return found;
}

PovNumbers PovInterpreter::primary() {
  const Deeper deeper(this);
  const PovToken& token = peek();
  if (token.kind == PovKind::kNumber) return number_of(take().number);
  if (next_is("(")) return parenthesised();
  if (next_is("<")) return vector_literal();
  if (token.kind != PovKind::kWord) fail_expected("a number");
  if (find(token.text)) return named_numbers();
  if (const auto known = constant(token.text)) {
    take();
    return *known;
  }
  if (is_function(token.text)) return function(std::string(take().text));
  fail_expected("a number");
}

PovNumbers PovInterpreter::named_numbers() {
  const std::string name(peek().text);
  const PovPlace at = place();
  const PovValue found = take_named();
  if (const auto* function = std::get_if<PovFunction>(&found)) return call(*function, name);
  if (const auto* spline = std::get_if<PovSpline>(&found)) return call(*spline);
  if (!std::holds_alternative<PovNumbers>(found)) fail_at(at.file, at.line, name + " is not a number");
  return std::get<PovNumbers>(found);
}

// (a), or (condition ? a : b).
PovNumbers PovInterpreter::parenthesised() {
  expect("(");
  PovNumbers found = logical();
  if (take_if("?")) {
    const bool condition = found[0] != 0;
    const PovNumbers yes = logical();
    expect(":");
    const PovNumbers no = logical();
    found = condition ? yes : no;
  }
  expect(")");
  return found;
}

PovNumbers PovInterpreter::vector_literal() {
  expect("<");
  PovNumbers found;
  found.size = 0;
  while (!take_if(">")) {
    if (found.size == 5) fail_expected(">");
    const PovNumbers part = sum();
    if (part.size != 1) fail("found a vector in a vector, expected a number");
    found[found.size++] = part[0];
    skip_comma();
  }
  if (found.size < 2) fail("a vector has " + std::to_string(found.size) + " numbers, expected 2 to 5");
  return found;
}

std::string PovInterpreter::string() {
  const Deeper deeper(this);
  const PovToken& token = peek();
  if (token.kind == PovKind::kString) return std::string(take().text);
  if (token.kind == PovKind::kWord) {
    if (is_string_function(token.text)) return string_function(std::string(take().text));
    if (const auto found = named<std::string>()) return *found;
  }
  fail_expected("a string");
}

PovValue PovInterpreter::value() {
  const PovToken token = peek();
  if (token.kind == PovKind::kString || (token.kind == PovKind::kWord && is_string_function(token.text)))
    return string();
  if (token.kind != PovKind::kWord) return numbers();
  const PovValue* known = find(token.text);
  const PovToken& after = here().file->tokens[std::min(here().next + 1, here().file->tokens.size() - 1)];
  const bool whole_array =
      known && std::holds_alternative<std::shared_ptr<PovArray>>(*known) && after.text != "[";
  if (whole_array || (is_callable(token.text) && after.text != "(")) return take_named();
  if (expression_is_next()) return numbers();
  if (take_if("array")) return array_value();
  if (take_if("function")) return function_value();
  if (take_if("spline")) return spline_value();
  if (std::any described = statements_->describe(token.text); described.has_value()) return described;
  if (find(token.text)) return take_named();
  // A declaration that has no use here, such as `normal {...}`.
  take();
  if (!next_is("{"))
    fail_at(place_of(token).file, token.line, "found " + in_quotes(token.text) + ", expected a value");
  skip_block();
  return PovIgnored{};
}

}  // namespace strad
