// What a user of the POV-Ray interpreter implements: the statements that describe a scene.
#pragma once

#include <any>
#include <optional>
#include <string>
#include <string_view>

#include "base/vec.h"
#include "import/pov/language/values.h"

namespace strad {

class PovStatements {
 public:
  virtual ~PovStatements() = default;
  // Reads the value of a declaration, such as a texture or an object. `word` is its first token, which is
  // next. Empty if it is none that the user knows; then no token is taken.
  virtual std::any describe(std::string_view word) = 0;
  // Called before `value`, which came from `describe`, is declared as `name`.
  virtual void name_declared(const std::string& name, std::any* value) = 0;
  // The value of a function of described things, such as min_extent. Its name was taken, its ( is next.
  virtual PovNumbers measured(const std::string& name) = 0;
  // What `thing`, which came from `describe`, makes of a vector. Nothing if it does not act on vectors.
  virtual std::optional<Vec3> transformed(const std::any& thing, Vec3 vector) = 0;
  // Reads the block of #default, from its {.
  virtual void default_block() = 0;
};

}  // namespace strad
