// Interprets POV-Ray's scene description language: tokens, directives, names, expressions. Knows no scenes.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/rgb.h"
#include "base/vec.h"
#include "import/pov/language/run.h"
#include "import/pov/language/statements.h"
#include "import/pov/language/values.h"
#include "import/report.h"

namespace strad {

class PovInterpreter {
 public:
  // The arguments must outlive the interpreter.
  PovInterpreter(const SkipOptions& options, const PovRun& run, PovFiles* files, ImportReport* report,
                 PovStatements* statements);
  PovInterpreter(const PovInterpreter&) = delete;
  PovInterpreter& operator=(const PovInterpreter&) = delete;

  // Tokens. Directives and macros before the next token are obeyed first.
  void open(const std::string& path);
  const PovToken& peek();
  PovToken take();
  bool next_is(std::string_view symbol_or_word);
  bool next_is_plainly(std::string_view symbol_or_word);  // without obeying directives: false if one is next
  bool take_if(std::string_view symbol_or_word);
  void expect(std::string_view symbol);
  void skip_comma() { take_if(","); }
  void skip_block();  // from { to its }
  void skip_item();   // a word and the expressions or the block after it
  std::string found_include(const std::string& name) const;  // the path of a file, or "" if it is missing
  PovPlace place();                                          // of the token that is next
  [[noreturn]] void fail(const std::string& what);           // at the token that is next
  [[noreturn]] void fail_expected(const std::string& expected);
  // Adds to what the file has made so far, and refuses what would fill the memory: strings and objects
  // double.
  void charge(size_t bytes);

  // Expressions.
  bool expression_is_next();
  PovNumbers numbers();
  double number();
  int integer();
  Vec3 vector();
  Vec2 vector2();
  Rgb colour();  // refuses transparency
  std::string string();
  // Sets a number or a vector that is declared as `name`, or declares it.
  void set(const std::string& name, const PovNumbers& value);
  // A function from its parameters or its {, after the word `function`; and its value.
  PovFunction function_value();
  double value_of(const PovFunction& function, Vec3 at);
  // To be called once where a function is used: reports that its values are not POV-Ray's, if so.
  void note_use(const PovFunction& function);
  // Takes the next token if it is the name of a declared thing of type T, and returns the thing. Otherwise
  // takes nothing and returns nothing.
  template <typename T>
  std::optional<T> named(std::string* name = nullptr) {
    if (peek().kind != PovKind::kWord) return {};
    const std::string word(peek().text);
    const PovValue* sample = sample_of(find(word));
    if (!sample || !thing_in<T>(*sample)) return {};
    if (name) *name = word;
    const PovValue found = take_named();
    const T* thing = thing_in<T>(found);
    if (!thing) fail_expected("an element of the array " + word);
    return *thing;
  }

  // Counts how deep expressions, blocks and directives are nested, and refuses what would overflow the stack.
  class Deeper {
   public:
    explicit Deeper(PovInterpreter* interpreter) : interpreter_(interpreter) {
      if (++interpreter->depth_ > kMaxDepth) interpreter->fail("expressions or blocks are nested too deep");
    }
    ~Deeper() { --interpreter_->depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;

   private:
    PovInterpreter* interpreter_;
  };

 private:
  static constexpr size_t kNowhere = ~size_t{0};
  static constexpr int kMaxDepth = 250;
  static constexpr size_t kMaxNesting = 100;      // of includes and macros
  static constexpr size_t kMaxValueDepth = 1000;  // of arrays and functions within each other
  struct Block {
    enum Kind { kIf, kWhile, kFor, kSwitch, kMacro } kind;
    size_t start = 0;  // the first token of a loop's body or condition
    std::string variable;
    double value = 0, last = 0, step = 1;
    uint32_t line = 0;
  };
  struct Cursor {
    std::shared_ptr<const PovFile> file;
    size_t next = 0;
    std::vector<Block> blocks;
    std::map<std::string, PovValue, std::less<>> locals;
    std::shared_ptr<const PovBindings> names;  // of a function
    size_t plain = kNowhere;  // the index of a token that is known to be no directive and no macro
  };

  Cursor& here() { return cursors_.back(); }
  const PovToken& raw() { return here().file->tokens[here().next]; }
  bool operator_is_next(std::string_view symbol);
  PovPlace place_of(const PovToken& token) const;
  const PovValue* find(std::string_view name) const;
  // `level`: how many cursors there are where it is declared; 0: as many as there are now.
  void declare(const std::string& name, PovValue value, bool local, size_t level = 0);

  // Directives, in directives.cpp; those that choose and repeat, in blocks.cpp.
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
  void count_token();
  void count_words(double words);
  PovNumbers finite_of(const std::string& function, double value);
  void declare_element(const std::string& name);

  // Expressions, in expressions.cpp; names and arrays, in arrays.cpp; colours, in colours.cpp.
  PovValue value();  // anything that can be declared
  bool truth();      // whether the number in parentheses that follows is not 0
  // The first element of an array, or of the arrays in it; anything but an array as it is.
  static const PovValue* sample_of(const PovValue* value);
  PovValue take_named();  // the value of the next name, with its indices if it is an array
  size_t indices_into(const PovArray& array, const std::string& name);
  PovValue array_value();
  void fill_array(PovArray* array, size_t dimension, size_t* next);
  PovValue kept(PovValue value);
  PovValue item_for(PovArray* array);
  void enclose(const PovValue& value, size_t* depth);

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
  // What a file can call, in callables.cpp.
  bool special_body(PovFunction* made);
  bool is_callable(std::string_view name) const;
  PovNumbers call_with(const PovFunction& function, const std::string& name,
                       const std::vector<PovNumbers>& given);
  PovValue spline_value();
  PovNumbers call(const PovFunction& function, const std::string& name);
  PovNumbers call(const PovSpline& spline);
  bool string_is_next();
  PovNumbers compared_strings();
  // Other files, in other_files.cpp.
  struct OpenFile {
    std::shared_ptr<const PovFile> file;  // null: it is missing, or written
    size_t next = 0;
    std::string written;  // the path of a file that is written; "" if it is read
  };
  void obey_fopen();
  void obey_read();
  void obey_write();
  PovValue value_in(OpenFile* from, const std::string& name);
  bool is_exhausted(std::string_view file) const;

  // Functions, in functions.cpp.
  std::vector<PovNumbers> arguments(size_t least, size_t most);
  PovNumbers function(const std::string& name);
  PovNumbers turbulence();
  void note_noise();
  PovNumbers function_of_other_things(const std::string& name);
  bool is_function(std::string_view name) const;
  bool is_string_function(std::string_view name) const;
  std::string string_function(const std::string& name);
  double random(size_t stream);

  const SkipOptions& options_;
  const PovRun& run_;
  PovFiles* files_;  // kept because tokens point into their texts
  ImportReport* report_;
  PovStatements* statements_;
  std::map<std::string_view, double> numbers_;  // that have names of their own, such as pi and clock
  std::vector<Cursor> cursors_;
  std::map<std::string, PovValue, std::less<>> globals_;
  std::map<std::string, OpenFile, std::less<>> open_files_;
  // What the scene has written, by path. It stays in memory, to be read or included again.
  std::map<std::string, std::string, std::less<>> written_;
  std::vector<uint32_t> random_states_;
  size_t steps_ = 0;  // turns of loops and calls of macros
  double words_ = 0;  // taken or skipped
  size_t made_ = 0;   // bytes
  int depth_ = 0;
};

}  // namespace strad
