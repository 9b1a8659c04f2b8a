// POV-Ray's scene description language, apart from what it describes: directives, names and expressions.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "import/import.h"
#include "import/pov/values.h"

namespace strad {

class PovLanguage {
 public:
  PovLanguage(const ImportOptions& options, ImportReport* report) : options_(options), report_(report) {}
  virtual ~PovLanguage() = default;
  PovLanguage(const PovLanguage&) = delete;
  PovLanguage& operator=(const PovLanguage&) = delete;

 protected:
  // The value of a declaration that begins with `word`, which is next: a texture, an object and so on.
  // Nothing if it is none of these.
  virtual std::optional<PovValue> describe(std::string_view word) = 0;
  virtual void default_block() = 0;  // of #default, from its {

  // --- Tokens; directives are obeyed on the way (import_pov_directives.cpp)
  void open(const std::string& path);
  const PovToken& peek();
  PovToken take();
  bool next_is(std::string_view symbol_or_word);
  bool operator_is_next(std::string_view symbol);
  bool next_is_plainly(std::string_view symbol_or_word);  // without obeying a directive that may be next
  bool take_if(std::string_view symbol_or_word);
  void expect(std::string_view symbol);
  void skip_block();  // from { to its }
  void skip_comma() { take_if(","); }
  PovPlace place();  // of the token that is next
  PovPlace place_of(const PovToken& token) const;
  [[noreturn]] void fail(const std::string& what);  // at the token that is next
  [[noreturn]] void fail_expected(const std::string& expected);
  // Refuses what cannot be shown, or reports that it is left out.
  void refuse(const PovProblem& problem);

  // --- Names (import_pov_directives.cpp)
  const PovValue* find(std::string_view name) const;
  void declare(const std::string& name, PovValue value, bool local);

  // --- Expressions (import_pov_expressions.cpp)
  PovValue value();  // anything that a name can stand for
  PovNumbers numbers();
  double number();
  int integer();
  bool truth();  // a number in parentheses, unlike 0
  Vec3 vector();
  Vec2 vector2();
  Rgb colour();  // refuses transparency
  std::string string();
  bool expression_is_next();
  // The declared thing of type T that is next, taken; nothing if something else is next.
  template <typename T>
  std::optional<T> named(std::string* name = nullptr) {
    if (peek().kind != PovKind::kWord) return {};
    const std::string word(peek().text);
    const PovValue* sample = sample_of(find(word));
    if (!sample || !std::holds_alternative<T>(*sample)) return {};
    if (name) *name = word;
    PovValue found = take_named();
    if (!std::holds_alternative<T>(found)) fail_expected("an element of the array " + word);
    return std::get<T>(std::move(found));
  }

  const ImportOptions& options_;
  ImportReport* report_;

 private:
  static constexpr size_t kNowhere = ~size_t{0};
  static constexpr int kMaxDepth = 250;
  struct Block {
    enum Kind { kIf, kWhile, kFor, kSwitch, kMacro } kind;
    size_t start = 0;  // where a loop begins again
    std::string variable;
    double value = 0, last = 0, step = 1;
    uint32_t line = 0;
  };
  struct Cursor {
    std::shared_ptr<const PovFile> file;
    size_t next = 0;
    std::vector<Block> blocks;
    std::map<std::string, PovValue, std::less<>> locals;
    size_t plain = kNowhere;  // this token is neither a directive nor a macro
  };

 protected:
  // Counts how deep expressions, blocks and directives lie in each other; refuses what would overrun the
  // stack.
  class Deeper {
   public:
    explicit Deeper(PovLanguage* language) : language_(language) {
      if (++language->depth_ > kMaxDepth) language->fail("expressions or blocks are nested too deep");
    }
    ~Deeper() { --language_->depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;

   private:
    PovLanguage* language_;
  };

 private:
  Cursor& here() { return cursors_.back(); }
  const PovToken& raw() { return here().file->tokens[here().next]; }
  void obey();
  void obey_declare(bool local);
  void obey_if(bool known);
  void obey_ifdef(bool wanted);
  void obey_while();
  void obey_for();
  void obey_switch();
  void obey_break();
  void obey_end();
  void obey_include();
  void obey_macro();
  std::string skip_branch();
  void push(Block::Kind kind, size_t start = 0);
  void call(PovMacro macro);
  void count_step();
  void declare_element(const std::string& name);
  std::string found_include(const std::string& name) const;

  // The first element of an array, and of arrays in it; anything else itself.
  static const PovValue* sample_of(const PovValue* value);
  PovValue take_named();  // what the name that is next, with its indices, stands for
  size_t indices_into(const PovArray& array, const std::string& name);
  PovValue array_value();
  void fill_array(PovArray* array, size_t dimension, size_t* next);

  std::optional<PovNumbers> constant(std::string_view word);
  PovNumbers logical();
  PovNumbers comparison();
  PovNumbers sum();
  PovNumbers product();
  PovNumbers unary();
  PovNumbers postfix();
  PovNumbers primary();
  PovNumbers parenthesised();
  PovNumbers vector_literal();
  PovNumbers colour_numbers();
  PovNumbers named_numbers();
  // Functions, in import_pov_functions.cpp.
  std::vector<PovNumbers> arguments(size_t least, size_t most);
  PovNumbers function(const std::string& name);
  PovNumbers function_of_other_things(const std::string& name);
  bool is_function(std::string_view name) const;
  bool is_string_function(std::string_view name) const;
  std::string string_function(const std::string& name);
  double random(size_t stream);

  std::map<std::string, std::shared_ptr<const PovFile>> files_;  // kept: tokens point into their texts
  std::vector<Cursor> cursors_;
  std::map<std::string, PovValue, std::less<>> globals_;
  std::vector<uint32_t> random_states_;
  size_t steps_ = 0;  // turns of loops and calls of macros so far
  int depth_ = 0;
};

}  // namespace strad
