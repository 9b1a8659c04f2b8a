// What a user of the POV-Ray interpreter implements: the statements that describe a scene.
#pragma once

#include <any>
#include <string>
#include <string_view>

namespace strad {

class PovStatements {
 public:
  virtual ~PovStatements() = default;
  // Reads the value of a declaration, such as a texture or an object. `word` is its first token, which is
  // next. Empty if it is none that the user knows; then no token is taken.
  virtual std::any describe(std::string_view word) = 0;
  // Called before `value`, which came from `describe`, is declared as `name`.
  virtual void name_declared(const std::string& name, std::any* value) = 0;
  // Reads the block of #default, from its {.
  virtual void default_block() = 0;
};

}  // namespace strad
