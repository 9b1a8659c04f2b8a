// POV-Ray's expressions: numbers, vectors, colours, arrays.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {
namespace {

// A number becomes a vector with that number in each part.
PovNumbers promoted(PovNumbers from, int size) {
  if (from.size == 1)
    for (int i = 1; i < size; ++i) from[i] = from[0];
  from.size = std::max(from.size, size);
  return from;
}

template <typename Operation>
PovNumbers by_parts(const PovNumbers& a, const PovNumbers& b, Operation operation) {
  const int size = std::max(a.size, b.size);
  const PovNumbers left = promoted(a, size), right = promoted(b, size);
  PovNumbers result;
  result.size = size;
  for (int i = 0; i < size; ++i) result[i] = operation(left[i], right[i]);
  return result;
}

bool starts_colour(std::string_view word) {
  return is_one_of(word, {"color", "colour", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "srgbf", "srgbt",
                          "srgbft", "red", "green", "blue", "filter", "transmit"});
}

// The part of a colour that a word names; 5 if it names none.
int first_part(std::string_view word) {
  const std::array<std::string_view, 5> parts{"red", "green", "blue", "filter", "transmit"};
  return static_cast<int>(std::find(parts.begin(), parts.end(), word) - parts.begin());
}

double linear_from_srgb_number(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// The numbers after rgb, rgbf, rgbt and so on, in the order red, green, blue, filter, transmit.
PovNumbers colour_from(std::string_view word, PovNumbers from) {
  const bool srgb = word.starts_with('s');
  if (srgb) word.remove_prefix(1);
  from = promoted(from, static_cast<int>(word.size()));
  if (word == "rgbt" && from.size >= 4) from[4] = from[3], from[3] = 0;
  if (word == "rgb") from[3] = from[4] = 0;
  for (int i = 0; i < 3 && srgb; ++i) from[i] = linear_from_srgb_number(from[i]);
  from.size = 5;
  return from;
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
    return std::holds_alternative<PovNumbers>(*sample);
  return constant(token.text) || starts_colour(token.text) || is_function(token.text);
}

PovNumbers PovInterpreter::numbers() {
  const PovToken& token = peek();
  if (token.kind == PovKind::kWord && starts_colour(token.text)) return colour_numbers();
  return sum();
}

PovNumbers PovInterpreter::colour_numbers() {
  if (!take_if("color")) take_if("colour");
  PovNumbers colour;
  colour.size = 5;
  for (bool first = true;; first = false) {
    const PovToken& token = peek();
    const bool word = token.kind == PovKind::kWord && starts_colour(token.text);
    if (!word && !first) return colour;
    if (!word) {
      colour = colour_from("rgb", sum());
      continue;
    }
    const std::string kind(take().text);
    const int part = first_part(kind);
    if (part < 5) {
      colour[part] = sum()[0];
    } else if (kind != "color" && kind != "colour") {
      colour = colour_from(kind, sum());
    }
  }
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

Rgb PovInterpreter::colour() {
  const PovPlace at = place();
  const PovNumbers found = promoted(numbers(), 3);
  if (found.size >= 4 && (found[3] != 0 || found[4] != 0))
    refuse({"transparency of a colour", at}, options_, report_);
  Rgb rgb;
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<float>(found[i]);
  if (!is_finite(rgb)) fail_at(at.file, at.line, "a colour is not finite");
  return rgb;
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
    const int colour_part = first_part(token.text);
    size_t part = token.text.size() == 1 ? kAxes.find(token.text[0])
                  : colour_part < 5      ? colour_part
                                         : kAxes.npos;
    if (token.text == "u" || token.text == "v") part = token.text == "v";
    if (token.text == "gray") {
      found = number_of(0.297 * found[0] + 0.589 * found[1] + 0.114 * found[2]);
    } else {
      if (part > 4) fail("found ." + std::string(token.text) + ", expected a part such as .x or .red");
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

const PovValue* PovInterpreter::sample_of(const PovValue* value) {
  while (value && std::holds_alternative<std::shared_ptr<PovArray>>(*value)) {
    const auto& items = std::get<std::shared_ptr<PovArray>>(*value)->items;
    const auto filled =
        std::find_if(items.begin(), items.end(), [](const auto& item) { return item.has_value(); });
    if (filled == items.end()) break;
    value = &**filled;
  }
  return value;
}

size_t PovInterpreter::indices_into(const PovArray& array, const std::string& name) {
  size_t index = 0;
  for (const size_t size : array.sizes) {
    expect("[");
    const double at = number();
    if (!(at >= 0 && at < static_cast<double>(size)))
      fail("index " + std::to_string(at) + " of the array " + name + ", expected 0 to " +
           std::to_string(size - 1));
    index = index * size + static_cast<size_t>(at);
    expect("]");
  }
  return index;
}

PovValue PovInterpreter::take_named() {
  const std::string name(take().text);
  PovValue found = *find(name);
  while (std::holds_alternative<std::shared_ptr<PovArray>>(found) && next_is_plainly("[")) {
    const auto array = std::get<std::shared_ptr<PovArray>>(found);
    const size_t index = indices_into(*array, name);
    if (!array->items[index]) fail("an element of the array " + name + " is used before it is declared");
    found = *array->items[index];
  }
  return found;
}

PovValue PovInterpreter::array_value() {
  constexpr double kMostItems = 1e8;
  constexpr size_t kMaxDimensions = 5;  // as in POV-Ray
  auto array = std::make_shared<PovArray>();
  double count = 1;
  while (next_is_plainly("[")) {
    take();
    const double size = number();
    count *= size;
    if (!(size >= 1 && count <= kMostItems)) fail("the array has " + std::to_string(count) + " elements");
    array->sizes.push_back(static_cast<size_t>(size));
    if (array->sizes.size() > kMaxDimensions) fail("the array has more than 5 dimensions");
    expect("]");
  }
  if (array->sizes.empty()) fail_expected("[");
  if (next_is_plainly("{")) {
    size_t next = 0;
    fill_array(array.get(), 0, &next);
  }
  array->items.resize(static_cast<size_t>(count));
  return array;
}

// Items are appended as they are read, so that a false count takes no memory.
void PovInterpreter::fill_array(PovArray* array, size_t dimension, size_t* next) {
  expect("{");
  for (size_t i = 0; i < array->sizes[dimension]; ++i) {
    if (dimension + 1 < array->sizes.size()) {
      fill_array(array, dimension + 1, next);
    } else {
      array->items.push_back(value());
      ++*next;
    }
    skip_comma();
  }
  expect("}");
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
  if (expression_is_next()) return numbers();
  if (take_if("array")) return array_value();
  if (std::any described = statements_->describe(token.text); described.has_value()) return described;
  if (find(token.text)) return take_named();
  // A declaration that has no use here, such as `normal {...}` or `function (x, y) {...}`.
  take();
  while (token.text == "function" && !next_is("{") && peek().kind != PovKind::kEnd) take();
  if (!next_is("{"))
    fail_at(place_of(token).file, token.line, "found " + in_quotes(token.text) + ", expected a value");
  skip_block();
  return PovIgnored{};
}

}  // namespace strad
