// What POV-Ray's language is used for: the interpreter knows expressions and directives, and asks here about
// all else.
#pragma once

#include <any>
#include <string>
#include <string_view>

namespace strad {

class PovStatements {
 public:
  virtual ~PovStatements() = default;
  // The value of a declaration that begins with `word`, the token that is next: a texture, an object and so
  // on. Empty if it is none of these; then no token is taken.
  virtual std::any describe(std::string_view word) = 0;
  // `value`, which came from `describe`, is about to be declared as `name`.
  virtual void name_declared(const std::string& name, std::any* value) = 0;
  // What follows #default, from its {.
  virtual void default_block() = 0;
};

}  // namespace strad
