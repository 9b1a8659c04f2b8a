// Functions and splines that a POV-Ray file declares, and what it compares.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"
#include "import/pov/language/interpreter.h"
#include "import/pov/language/program.h"
#include "import/pov/language/spline.h"

namespace strad {

bool PovInterpreter::is_callable(std::string_view name) const {
  const PovValue* known = sample_of(find(name));
  return known && (std::holds_alternative<PovFunction>(*known) || std::holds_alternative<PovSpline>(*known));
}

// [(parameters)] { body }
PovFunction PovInterpreter::function_value() {
  PovFunction made;
  if (take_if("(")) {
    while (!take_if(")")) {
      if (raw().kind != PovKind::kWord) fail_expected("the name of a parameter");
      made.parameters.emplace_back(raw().text);
      ++here().next;
      if (!next_is(")")) expect(",");
    }
  } else {
    made.parameters = {"x", "y", "z"};
    while (!next_is("{") && expression_is_next()) number();  // the size of a picture made of it
  }
  if (!next_is("{")) fail_expected("{");
  made.file = here().file;
  made.body = here().next + 1;
  if (special_body(&made)) return made;
  auto names = std::make_shared<PovBindings>();
  int depth = 0;
  do {
    const PovToken& token = raw();
    if (token.kind == PovKind::kEnd) fail("a function is not closed, expected }");
    if (token.kind == PovKind::kSymbol) depth += token.text == "{" ? 1 : token.text == "}" ? -1 : 0;
    if (token.kind == PovKind::kWord)
      if (const PovValue* known = find(token.text)) {
        enclose(*known, &names->depth);
        names->values.insert_or_assign(std::string(token.text), *known);
      }
    ++here().next;
  } while (depth > 0);
  made.names = std::move(names);
  if (made.unknown.empty())
    made.program = pov_program(made, [this](std::string_view word) {
      const auto known = numbers_.find(word);
      return known == numbers_.end() ? std::optional<double>() : known->second;
    });
  return made;
}

// A function that is a transformation, a spline, or one of POV-Ray's own. False, with the { still next, if it
// is none of these, or none that is known.
bool PovInterpreter::special_body(PovFunction* made) {
  const PovToken first = here().file->tokens[made->body];
  if (first.kind != PovKind::kWord) return false;
  if (first.text == "transform") {
    expect("{");
    made->thing = std::make_shared<const std::any>(statements_->describe(peek().text));
    expect("}");
    return true;
  }
  if (first.text == "spline") {
    expect("{");
    take();
    made->spline = std::make_shared<const PovSpline>(std::get<PovSpline>(spline_value()));
    expect("}");
    return true;
  }
  if (first.text == "internal") {  // internal(NUMBER)
    const PovToken number = here().file->tokens[std::min(made->body + 2, here().file->tokens.size() - 1)];
    if (number.kind == PovKind::kNumber)
      made->native = pov_internal_function(static_cast<int>(std::clamp(number.number, -1.0, 1e3)));
  }
  if (!made->native && is_one_of(first.text, {"pattern", "pigment", "internal"})) made->unknown = first.text;
  return false;
}

void PovInterpreter::note_use(const PovFunction& function) {
  if ((function.native && is_noise(*function.native)) || (function.program && function.program->noisy))
    note_noise();
}

// The arguments follow in parentheses.
PovNumbers PovInterpreter::call(const PovFunction& function, const std::string& name) {
  count_step();
  return call_with(function, name, arguments(1, 100));
}

double PovInterpreter::value_of(const PovFunction& function, Vec3 at) {
  if (function.program && function.parameters.size() == 3) {
    count_words(function.program->cost / 16);  // about as long as a word takes
    return run(*function.program, std::array{at.x, at.y, at.z});
  }
  return call_with(function, "", {number_of(at.x), number_of(at.y), number_of(at.z)})[0];
}

PovNumbers PovInterpreter::call_with(const PovFunction& function, const std::string& name,
                                     const std::vector<PovNumbers>& given) {
  const Deeper deeper(this);
  if (function.thing) {
    Vec3 vector{given[0][0], given[0][1], given[0][2]};
    if (given.size() == 3) vector = {given[0][0], given[1][0], given[2][0]};
    const auto result = statements_->transformed(*function.thing, vector);
    if (!result) fail("the function " + name + " does not act on vectors");
    PovNumbers numbers;
    numbers.size = 3;
    numbers.parts = {result->x, result->y, result->z};
    return numbers;
  }
  if (function.spline) {
    if (given.size() != 1) fail("the function " + name + ", made of a spline, has one argument");
    return spline_at(*function.spline, function.spline->type, given[0][0]);
  }
  if (!function.unknown.empty()) {
    refuse({"the function " + name + ", made of " + function.unknown + ",", place()}, options_, report_);
    return number_of(0);
  }
  if (function.native) {
    std::vector<double> values;
    for (const PovNumbers& one : given) values.push_back(one[0]);
    if (values.size() < function.native->least || values.size() > function.native->most)
      fail("the function " + name + " has " + std::to_string(given.size()) + " arguments, expected " +
           std::to_string(function.native->least));
    note_use(function);
    return finite_of(name, function.native->call(values));
  }
  if (given.size() != function.parameters.size())
    fail("the function " + name + " has " + std::to_string(given.size()) + " arguments, expected " +
         std::to_string(function.parameters.size()));
  if (function.program) {
    std::vector<double> values;
    for (const PovNumbers& one : given) values.push_back(one[0]);
    count_words(function.program->cost / 16);
    note_use(function);
    return finite_of(name, run(*function.program, values));
  }
  if (cursors_.size() >= kMaxNesting) fail("functions are nested too deep");
  Cursor inside;
  inside.file = function.file;
  inside.next = function.body;
  inside.names = function.names;
  for (size_t i = 0; i < given.size(); ++i) inside.locals.insert_or_assign(function.parameters[i], given[i]);
  const size_t level = cursors_.size();
  cursors_.push_back(std::move(inside));
  const PovNumbers result = logical();
  if (!next_is("}") || cursors_.size() != level + 1) fail_expected("an operator or }");
  cursors_.pop_back();
  return result;
}

// { [type] time, vector, ... }
PovValue PovInterpreter::spline_value() {
  PovSpline made;
  made.type = "linear_spline";
  expect("{");
  if (const auto known = named<PovSpline>()) made = *known;
  while (!take_if("}")) {
    if (take_if(",")) continue;
    if (peek().kind == PovKind::kWord && is_spline_type(peek().text)) {
      made.type = take().text;
      continue;
    }
    const double time = number();
    skip_comma();
    const auto place_of_time = [](const std::pair<double, PovNumbers>& a, double b) { return a.first < b; };
    const auto after = std::lower_bound(made.points.begin(), made.points.end(), time, place_of_time);
    const PovNumbers vector = promoted(numbers(), 2);
    if (after != made.points.end() && after->first == time)
      after->second = vector;
    else
      made.points.insert(after, {time, vector});
  }
  if (made.points.empty()) fail("a spline has no points");
  return made;
}

// The time follows in parentheses, perhaps with a type.
PovNumbers PovInterpreter::call(const PovSpline& spline) {
  expect("(");
  const double time = number();
  std::string type = spline.type;
  if (take_if(",")) {
    if (peek().kind != PovKind::kWord || !is_spline_type(peek().text)) fail_expected("the type of a spline");
    type = take().text;
  }
  expect(")");
  return spline_at(spline, type, time);
}

bool PovInterpreter::string_is_next() {
  const PovToken& token = peek();
  if (token.kind == PovKind::kString) return true;
  if (token.kind != PovKind::kWord) return false;
  const PovValue* known = sample_of(find(token.text));
  return is_string_function(token.text) || (known && std::holds_alternative<std::string>(*known));
}

PovNumbers PovInterpreter::compared_strings() {
  const std::string left = string();
  if (peek().kind != PovKind::kSymbol || !is_one_of(peek().text, {"<", ">", "<=", ">=", "=", "!="}))
    fail_expected("a comparison of strings");
  const std::string sign(take().text);
  const int order = left.compare(string());
  return number_of(sign == "<"    ? order < 0
                   : sign == ">"  ? order > 0
                   : sign == "<=" ? order <= 0
                   : sign == ">=" ? order >= 0
                   : sign == "="  ? order == 0
                                  : order != 0);
}

}  // namespace strad
