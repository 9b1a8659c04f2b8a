// The two kinds of errors that the library throws. Their text names the file and the place, and says what was
// found and what was expected.
#pragma once

#include <stdexcept>
#include <string>

namespace strad {

// What the user gave is wrong: a file's content, an option, a stream.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The system failed: a file cannot be opened, read or written.
struct IoError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace strad
