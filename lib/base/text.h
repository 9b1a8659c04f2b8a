// Text files written by other programs: read, checked to be text, and parsed strictly.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace strad {

// The content of a file; "-" is standard input. Throws IoError, or BadInput if it is empty, a directory,
// UTF-16 or not text; the message begins with `text_name(path)`. A UTF-8 byte order mark is removed.
std::string read_text(const std::string& path);

// What messages call the file: its path, or "standard input".
std::string text_name(const std::string& path);

// The path meant by `reference`, which stands in the file `path`: relative to that file's folder.
std::string path_beside(const std::string& path, const std::string& reference);

// Throws BadInput "name:line: what".
[[noreturn]] void fail_at(const std::string& name, uint32_t line, const std::string& what);

// `text` for messages: in double quotes, control characters and what is no UTF-8 shown as ?, cut after
// `most` bytes.
std::string in_quotes(std::string_view text, size_t most = 40);

// `text` as a decimal number that is finite as a float. Nothing if any part of it is something else, such as
// nan, 0x10 or 0,5.
std::optional<double> number_in(std::string_view text);
std::optional<int64_t> integer_in(std::string_view text);

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words);

// Removes the next word from the front of `rest` and returns it; empty at the end. Blanks separate words.
std::string_view next_word(std::string_view* rest);
std::string_view trimmed(std::string_view text);
// The words of `text`, separated by single blanks: a name that may hold blanks.
std::string single_spaced(std::string_view text);

// The lines of a text, which end with LF, CR LF or CR. A line that ends with a backslash is continued by the
// next one, unless it is a comment (#).
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_(text) {}
  bool next();
  std::string_view line() const { return line_; }  // trimmed; valid until the next call
  uint32_t number() const { return number_; }      // of the first line it was joined from; counted from 1

 private:
  std::string_view take_physical();
  std::string_view rest_, line_;
  std::string joined_;
  uint32_t number_ = 0, taken_ = 0;
};

}  // namespace strad
