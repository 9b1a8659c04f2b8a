#include "import/pov/language/program.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.h"

namespace strad {
namespace {

using Code = PovProgram::Code;

constexpr size_t kDeepest = 48;  // numbers on the stack, and nested parentheses
constexpr double kMostSteps = 1e5;

struct Operator {
  std::string_view symbol;
  Code code;
};
constexpr std::array<Operator, 6> kComparisons{{{"<", Code::kLess},
                                                {">", Code::kGreater},
                                                {"<=", Code::kLessOrEqual},
                                                {">=", Code::kGreaterOrEqual},
                                                {"=", Code::kEqual},
                                                {"!=", Code::kUnequal}}};

// Follows the grammar of the interpreter's expressions. Each function returns false for what is not numbers.
class Compiler {
 public:
  Compiler(const PovFunction& function,
           const std::function<std::optional<double>(std::string_view)>& constant)
      : function_(function), constant_(constant), next_(function.body) {
    made_.parameters = function.parameters.size();
  }
  std::shared_ptr<const PovProgram> program() {
    if (!logical() || !is("}") || !(made_.cost <= kMostSteps) || highest_ > kDeepest) return nullptr;
    return std::make_shared<const PovProgram>(std::move(made_));
  }

 private:
  const PovToken& token() const { return function_.file->tokens[next_]; }
  bool is(std::string_view symbol) const {
    return token().kind == PovKind::kSymbol && token().text == symbol;
  }
  bool take(std::string_view symbol) {
    if (!is(symbol)) return false;
    ++next_;
    return true;
  }
  // Adds a step that takes `taken` numbers from the stack and leaves one.
  bool add(PovProgram::Step step, size_t taken) {
    made_.cost += 1 + (step.program ? step.program->cost : 0);
    made_.noisy =
        made_.noisy || (step.program && step.program->noisy) || (step.native && is_noise(*step.native));
    height_ = height_ + 1 - taken;
    highest_ = std::max(highest_, height_);
    made_.steps.push_back(std::move(step));
    return made_.steps.size() < kMostSteps;
  }
  bool add(Code code, size_t taken) {
    PovProgram::Step step;
    step.code = code;
    return add(std::move(step), taken);
  }
  bool add_constant(double value) {
    PovProgram::Step step;
    step.value = value;
    return add(std::move(step), 0);
  }

  bool logical() {
    if (!comparison()) return false;
    while (is("&") || is("|")) {
      const Code code = take("&") ? Code::kAnd : (++next_, Code::kOr);
      if (!comparison() || !add(code, 2)) return false;
    }
    return true;
  }
  bool comparison() {
    if (!sum()) return false;
    while (true) {
      const auto found = std::find_if(kComparisons.begin(), kComparisons.end(),
                                      [this](const Operator& known) { return is(known.symbol); });
      if (found == kComparisons.end()) return true;
      ++next_;
      if (!sum() || !add(found->code, 2)) return false;
    }
  }
  bool sum() {
    if (!product()) return false;
    while (is("+") || is("-")) {
      const Code code = take("+") ? Code::kAdd : (++next_, Code::kSubtract);
      if (!product() || !add(code, 2)) return false;
    }
    return true;
  }
  bool product() {
    if (!unary()) return false;
    while (is("*") || is("/")) {
      const Code code = take("*") ? Code::kMultiply : (++next_, Code::kDivide);
      if (!unary() || !add(code, 2)) return false;
    }
    return true;
  }
  // Signs bind less than powers: -x^2 is not (-x)^2.
  bool unary() {
    std::string signs;
    while (is("+") || is("-") || is("!")) signs += function_.file->tokens[next_++].text;
    if (!power()) return false;
    for (auto sign = signs.rbegin(); sign != signs.rend(); ++sign)
      if (*sign != '+' && !add(*sign == '-' ? Code::kNegate : Code::kNot, 1)) return false;
    return true;
  }
  bool power() {
    if (!primary()) return false;
    while (take("^")) {
      const bool negative = take("-");
      if (!primary() || (negative && !add(Code::kNegate, 1)) || !add(Code::kPower, 2)) return false;
    }
    return true;
  }
  bool primary() {
    if (++depth_ > kDeepest) return false;
    const bool done = token().kind == PovKind::kNumber ? add_constant(function_.file->tokens[next_++].number)
                      : is("(")                        ? parenthesised()
                      : token().kind == PovKind::kWord ? name()
                                                       : false;
    --depth_;
    return done && !is(".");
  }
  bool parenthesised() {
    ++next_;
    if (!logical()) return false;
    if (take("?") && !(logical() && take(":") && logical() && add(Code::kChoose, 3))) return false;
    return take(")");
  }
  bool name() {
    const std::string_view word = token().text;
    ++next_;
    const auto& parameters = function_.parameters;
    if (const auto found = std::find(parameters.begin(), parameters.end(), word); found != parameters.end()) {
      PovProgram::Step step;
      step.code = Code::kArgument;
      step.count = static_cast<uint32_t>(found - parameters.begin());
      return add(std::move(step), 0);
    }
    if (const auto bound = function_.names->values.find(word); bound != function_.names->values.end())
      return bound_name(bound->second);
    if (const auto known = constant_(word)) return add_constant(*known);
    if (const PovNumberFunction* native = pov_number_function(word)) return call(native, nullptr);
    return false;
  }
  bool bound_name(const PovValue& value) {
    if (const auto* function = std::get_if<PovFunction>(&value))
      return (function->native || function->program) && call(function->native, function->program);
    const auto* numbers = std::get_if<PovNumbers>(&value);
    if (!numbers) return false;
    if (numbers->size == 1) return add_constant((*numbers)[0]);
    if (!take(".") || token().kind != PovKind::kWord) return false;
    const std::string_view part = token().text;
    const int index = part == "x" || part == "red" || part == "u"     ? 0
                      : part == "y" || part == "green" || part == "v" ? 1
                      : part == "z" || part == "blue"                 ? 2
                                                                      : -1;
    if (index < 0 || index >= numbers->size) return false;
    ++next_;
    return add_constant((*numbers)[index]);
  }
  // Its arguments follow in parentheses.
  bool call(const PovNumberFunction* native, const std::shared_ptr<const PovProgram>& program) {
    if (!take("(")) return false;
    PovProgram::Step step;
    step.code = native ? Code::kNative : Code::kProgram;
    step.native = native;
    step.program = program;
    do {
      if (!logical()) return false;
      ++step.count;
    } while (take(","));
    if (!take(")")) return false;
    const bool fits = native ? step.count >= native->least && step.count <= native->most
                             : step.count == program->parameters;
    const size_t count = step.count;
    return fits && add(std::move(step), count);
  }

  const PovFunction& function_;
  const std::function<std::optional<double>(std::string_view)>& constant_;
  size_t next_;
  PovProgram made_;
  size_t height_ = 0, highest_ = 0, depth_ = 0;
};

double combined(Code code, double a, double b) {
  switch (code) {
    case Code::kAdd:
      return a + b;
    case Code::kSubtract:
      return a - b;
    case Code::kMultiply:
      return a * b;
    case Code::kDivide:
      return a / b;
    case Code::kPower:
      return std::pow(a, b);
    case Code::kLess:
      return a < b;
    case Code::kGreater:
      return a > b;
    case Code::kLessOrEqual:
      return a <= b;
    case Code::kGreaterOrEqual:
      return a >= b;
    case Code::kEqual:
      return a == b;
    case Code::kUnequal:
      return a != b;
    case Code::kAnd:
      return a != 0 && b != 0;
    default:
      return a != 0 || b != 0;  // kOr
  }
}

}  // namespace

std::shared_ptr<const PovProgram> pov_program(
    const PovFunction& function, const std::function<std::optional<double>(std::string_view)>& constant) {
  return Compiler(function, constant).program();
}

double run(const PovProgram& program, std::span<const double> arguments) {
  std::array<double, kDeepest> stack;
  size_t size = 0;
  for (const PovProgram::Step& step : program.steps) {
    switch (step.code) {
      case Code::kConstant:
        stack[size++] = step.value;
        break;
      case Code::kArgument:
        stack[size++] = arguments[step.count];
        break;
      case Code::kNegate:
        stack[size - 1] = -stack[size - 1];
        break;
      case Code::kNot:
        stack[size - 1] = stack[size - 1] == 0;
        break;
      case Code::kChoose:
        size -= 2;
        stack[size - 1] = stack[size - 1] != 0 ? stack[size] : stack[size + 1];
        break;
      case Code::kNative:
      case Code::kProgram: {
        size -= step.count;
        const std::span<const double> given(stack.data() + size, step.count);
        stack[size] = step.native ? step.native->call(given) : run(*step.program, given);
        ++size;
        break;
      }
      default:
        --size;
        stack[size - 1] = combined(step.code, stack[size - 1], stack[size]);
    }
  }
  return stack[0];
}

}  // namespace strad
