// POV-Ray's functions of numbers, compiled: surfaces take their values at very many points.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "import/pov/language/number_functions.h"
#include "import/pov/language/values.h"

namespace strad {

// Steps on a stack of numbers.
struct PovProgram {
  enum class Code : uint8_t {
    kConstant,
    kArgument,
    kNegate,
    kNot,
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kPower,
    kLess,
    kGreater,
    kLessOrEqual,
    kGreaterOrEqual,
    kEqual,
    kUnequal,
    kAnd,
    kOr,
    kChoose,   // condition, yes, no
    kNative,   // a function of `count` numbers
    kProgram,  // the same, compiled
  };
  struct Step {
    Code code = Code::kConstant;
    uint32_t count = 0;  // of arguments; the index of an argument
    double value = 0;
    const PovNumberFunction* native = nullptr;
    std::shared_ptr<const PovProgram> program;
  };
  std::vector<Step> steps;
  size_t parameters = 0;
  double cost = 0;  // steps, with those of the programs that it calls
  bool noisy = false;
};

// The program of a function's body. Null if there is more in it than numbers, or if it would take very many
// steps. `constant`: the value of a name that is not bound, such as pi.
std::shared_ptr<const PovProgram> pov_program(
    const PovFunction& function, const std::function<std::optional<double>(std::string_view)>& constant);

// As many arguments as it has parameters. It may have no finite value.
double run(const PovProgram& program, std::span<const double> arguments);

}  // namespace strad
