// POV-Ray scene files as tokens.
#include "import/pov/language/tokens.h"

#include <cctype>
#include <cmath>
#include <cstdlib>

#include "base/text.h"

namespace strad {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word_start(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_word(char c) { return is_word_start(c) || is_digit(c); }

class Lexer {
 public:
  explicit Lexer(PovFile* file) : file_(file), text_(file->text) {}
  void run();

 private:
  char at(size_t i) const { return i < text_.size() ? text_[i] : '\0'; }
  bool skip_comment();
  void take(PovKind kind, size_t end);
  void take_number();
  void take_string();
  [[noreturn]] void fail(const std::string& what) const { fail_at(file_->name, line_, what); }

  PovFile* file_;
  std::string_view text_;
  size_t next_ = 0;
  uint32_t line_ = 1;
};

// Comments between /* and */ may be nested.
bool Lexer::skip_comment() {
  if (at(next_) != '/') return false;
  if (at(next_ + 1) == '/') {
    next_ = std::min(text_.find('\n', next_), text_.size());
    return true;
  }
  if (at(next_ + 1) != '*') return false;
  int depth = 0;
  do {
    if (next_ >= text_.size()) fail("a comment is not closed, expected */");
    if (at(next_) == '/' && at(next_ + 1) == '*') {
      ++depth, ++next_;
    } else if (at(next_) == '*' && at(next_ + 1) == '/') {
      --depth, ++next_;
    } else if (at(next_) == '\n') {
      ++line_;
    }
    ++next_;
  } while (depth > 0);
  return true;
}

void Lexer::take(PovKind kind, size_t end) {
  file_->tokens.push_back({kind, line_, text_.substr(next_, end - next_)});
  next_ = end;
}

void Lexer::take_number() {
  size_t end = next_;
  while (is_digit(at(end))) ++end;
  if (at(end) == '.') ++end;
  while (is_digit(at(end))) ++end;
  if (at(end) == 'e' || at(end) == 'E') {
    size_t digits = end + 1;
    if (at(digits) == '+' || at(digits) == '-') ++digits;
    if (is_digit(at(digits))) {
      end = digits;
      while (is_digit(at(end))) ++end;
    }
  }
  const auto value = number_in(text_.substr(next_, end - next_));
  if (!value) fail("found " + in_quotes(text_.substr(next_, end - next_)) + ", expected a finite number");
  take(PovKind::kNumber, end);
  file_->tokens.back().number = *value;
}

void Lexer::take_string() {
  ++next_;
  size_t end = next_;
  while (end < text_.size() && text_[end] != '"' && text_[end] != '\n') end += text_[end] == '\\' ? 2 : 1;
  if (at(end) != '"') fail("a string is not closed, expected \"");
  take(PovKind::kString, end);
  ++next_;
}

void Lexer::run() {
  while (next_ < text_.size()) {
    const char c = text_[next_];
    if (c == '\n') ++line_;
    if (std::isspace(static_cast<unsigned char>(c))) {
      ++next_;
    } else if (is_digit(c) || (c == '.' && is_digit(at(next_ + 1)))) {
      take_number();
    } else if (is_word_start(c) || c == '#') {
      if (c == '#') ++next_;
      while (c == '#' && (at(next_) == ' ' || at(next_) == '\t')) ++next_;
      size_t end = next_;
      while (is_word(at(end))) ++end;
      if (end == next_) fail("found #, expected a directive such as #declare");
      take(c == '#' ? PovKind::kDirective : PovKind::kWord, end);
    } else if (c == '"') {
      take_string();
    } else if (!skip_comment()) {
      const bool is_long = at(next_ + 1) == '=' && (c == '<' || c == '>' || c == '!');
      take(PovKind::kSymbol, next_ + (is_long ? 2 : 1));
    }
  }
  take(PovKind::kEnd, next_);
}

}  // namespace

std::shared_ptr<const PovFile> read_pov_file(const std::string& path) {
  auto file = std::make_shared<PovFile>();
  file->path = path;
  file->name = text_name(path);
  file->text = read_text(path);
  Lexer(file.get()).run();
  return file;
}

std::shared_ptr<const PovFile> pov_file_of(std::string text, const std::string& name) {
  auto file = std::make_shared<PovFile>();
  file->path = file->name = name;
  file->text = std::move(text);
  Lexer(file.get()).run();
  return file;
}

}  // namespace strad
