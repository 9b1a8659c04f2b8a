// Text files written by other programs: read whole, checked to be text, taken apart strictly.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace strad {

// The whole of a file; "-" is standard input. Throws IoError, or BadInput if it is empty, a directory, UTF-16
// or not text; the message begins with `text_name(path)`. A byte order mark of UTF-8 is taken off.
std::string read_text(const std::string& path);

// What messages call the file: its path, or "standard input".
std::string text_name(const std::string& path);

// The path that `reference`, found inside the file `path`, stands for: relative to that file's folder.
std::string path_beside(const std::string& path, const std::string& reference);

// Throws BadInput "name:line: what".
[[noreturn]] void fail_at(const std::string& name, uint32_t line, const std::string& what);

// For messages: in double quotes, control characters as ?, cut after `most` characters.
std::string in_quotes(std::string_view text, size_t most = 40);

// The whole of `text` as a decimal number, finite as a float; nothing else is taken for one (nan, 0x10, 0,5).
std::optional<double> number_in(std::string_view text);
std::optional<int64_t> integer_in(std::string_view text);

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words);

// Takes the next word, ended by blanks, off the front of `rest`; empty at the end.
std::string_view next_word(std::string_view* rest);
std::string_view trimmed(std::string_view text);

// The lines of a text. A line ended by a backslash goes on in the next one, unless it is a comment (#). Lines
// end with LF, CR LF or CR.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  bool next();
  std::string_view line() const { return line_; }  // trimmed; valid until the next call
  uint32_t number() const { return number_; }      // of its first part, from 1

 private:
  std::string_view take_physical();
  std::string_view rest_, line_;
  std::string joined_;
  uint32_t number_ = 0, taken_ = 0;
};

}  // namespace strad
