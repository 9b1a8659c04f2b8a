// POV-Ray's directives: what is declared, repeated, chosen, included.
#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {
namespace {

// Turns of loops and calls of macros. A file that takes more is refused as endless.
constexpr size_t kMaxSteps = 5'000'000;

bool opens_block(std::string_view directive) {
  return is_one_of(directive, {"if", "ifdef", "ifndef", "while", "for", "switch", "macro"});
}

bool shapes_blocks(std::string_view directive) {
  return opens_block(directive) ? directive != "macro"
                                : is_one_of(directive, {"else", "elseif", "end", "case", "range", "break"});
}

}  // namespace

// Whether `symbol` continues an expression. Directives such as #declare end the expression before them, and
// must not be obeyed before its value is used.
bool PovInterpreter::operator_is_next(std::string_view symbol) {
  if (raw().kind == PovKind::kDirective && !shapes_blocks(raw().text)) return false;
  return next_is(symbol);
}

// Obeys the directive that is next.
void PovInterpreter::obey() {
  const Deeper deeper(this);
  const std::string name(raw().text);
  const std::string file = here().file->name;
  const uint32_t line = raw().line;
  ++here().next;
  if (name == "declare" || name == "local") return obey_declare(name == "local");
  if (name == "if") return obey_if(false);
  if (name == "ifdef" || name == "ifndef") return obey_ifdef(name == "ifdef");
  if (name == "while") return obey_while();
  if (name == "for") return obey_for();
  if (name == "switch") return obey_switch();
  if (name == "end") return obey_end();
  if (name == "break") return obey_break();
  if (name == "include") return obey_include();
  if (name == "macro") return obey_macro();
  if (name == "default") return statements_->default_block();
  if (name == "version") {
    if (take_if("unofficial")) take();
    numbers();
    if (next_is_plainly(";")) take();
  } else if (name == "case" || name == "range") {  // the case before it was taken and has no #break
    expect("(");
    while (!take_if(")")) take();
  } else if (name == "else" || name == "elseif") {  // the branch before it was taken
    if (here().blocks.empty()) fail_at(file, line, "found #" + name + " outside a block");
    while (skip_branch() != "end") continue;
    here().blocks.pop_back();
  } else if (name == "undef") {
    const std::string undefined(raw().text);
    ++here().next;
    if (here().locals.erase(undefined) == 0) globals_.erase(undefined);
  } else if (name == "debug" || name == "warning" || name == "render" || name == "statistics") {
    string();
  } else if (name == "error") {
    fail_at(file, line, "#error " + in_quotes(string(), 200));
  } else {
    fail_at(file, line, "#" + name + " is not supported");
  }
}

void PovInterpreter::obey_declare(bool local) {
  if (raw().kind == PovKind::kWord && raw().text == "deprecated") {  // deprecated [once] "why" NAME
    ++here().next;
    take_if("once");
    string();
  }
  if (raw().kind != PovKind::kWord) fail_expected("the name to declare");
  const std::string name(raw().text);
  ++here().next;
  if (next_is("[")) return declare_element(name);
  expect("=");
  PovValue declared = value();
  if (auto* thing = std::get_if<std::any>(&declared)) statements_->name_declared(name, thing);
  declare(name, std::move(declared), local);
  if (next_is_plainly(";")) take();
}

void PovInterpreter::declare_element(const std::string& name) {
  const PovValue* known = find(name);
  if (!known || !std::holds_alternative<std::shared_ptr<PovArray>>(*known)) fail(name + " is not an array");
  const auto array = std::get<std::shared_ptr<PovArray>>(*known);
  const size_t index = indices_into(*array, name);
  expect("=");
  array->items[index] = value();
  if (next_is_plainly(";")) take();
}

void PovInterpreter::push(Block::Kind kind, size_t start) {
  Block block;
  block.kind = kind;
  block.start = start;
  block.line = raw().line;
  here().blocks.push_back(block);
}

// Skips tokens up to and including the next #else, #elseif, #case, #range or #end of the current block.
// Returns which it was.
std::string PovInterpreter::skip_branch() {
  for (int depth = 0;; ++here().next) {
    const PovToken& token = raw();
    if (token.kind == PovKind::kEnd) fail("found the end of the file, expected #end");
    if (token.kind != PovKind::kDirective) continue;
    const bool branch =
        token.text == "else" || token.text == "elseif" || token.text == "case" || token.text == "range";
    if (depth == 0 && (branch || token.text == "end")) {
      ++here().next;
      return std::string(token.text);
    }
    if (opens_block(token.text)) ++depth;
    if (token.text == "end") --depth;
  }
}

void PovInterpreter::obey_if(bool known) {
  bool taken = known || truth();
  while (!taken) {
    const std::string branch = skip_branch();
    if (branch == "end") return;
    taken = branch == "else" || (branch == "elseif" && truth());
  }
  push(Block::kIf);
}

void PovInterpreter::obey_ifdef(bool wanted) {
  if (!(raw().kind == PovKind::kSymbol && raw().text == "(")) fail_expected("(");
  ++here().next;
  bool defined = raw().kind == PovKind::kWord && find(raw().text);
  const std::string name(raw().text);
  ++here().next;
  if (next_is("[") && defined) {
    const PovValue* array = find(name);
    if (!std::holds_alternative<std::shared_ptr<PovArray>>(*array)) fail(name + " is not an array");
    const auto items = std::get<std::shared_ptr<PovArray>>(*array);
    defined = items->items[indices_into(*items, name)].has_value();
  }
  expect(")");
  if (defined == wanted) return push(Block::kIf);
  for (std::string branch = skip_branch(); branch != "end"; branch = skip_branch()) {
    if (branch == "else" || (branch == "elseif" && truth())) return push(Block::kIf);
  }
}

void PovInterpreter::count_step() {
  if (++steps_ > kMaxSteps) fail("the file takes more than " + std::to_string(kMaxSteps) + " turns of loops");
}

void PovInterpreter::obey_while() {
  const size_t start = here().next;
  count_step();
  if (truth()) return push(Block::kWhile, start);
  while (skip_branch() != "end") continue;
}

void PovInterpreter::obey_for() {
  expect("(");
  Block loop;
  loop.kind = Block::kFor;
  if (raw().kind != PovKind::kWord) fail_expected("the name of the loop's variable");
  loop.variable = raw().text;
  ++here().next;
  expect(",");
  loop.value = number();
  expect(",");
  loop.last = number();
  if (take_if(",")) loop.step = number();
  expect(")");
  if (!(loop.step != 0)) fail("the loop never ends: its step is 0");
  const bool runs = loop.step > 0 ? loop.value <= loop.last : loop.value >= loop.last;
  if (!runs) {
    while (skip_branch() != "end") continue;
    return;
  }
  loop.start = here().next;
  loop.line = raw().line;
  here().blocks.push_back(loop);
  declare(loop.variable, number_of(loop.value), true);
}

void PovInterpreter::obey_switch() {
  expect("(");
  const double wanted = number();
  expect(")");
  // The first #case follows `(X)`, so the next branch is one of this block.
  for (std::string branch = skip_branch(); branch != "end"; branch = skip_branch()) {
    bool taken = branch == "else";
    if (branch == "case" || branch == "range") {
      expect("(");
      const double low = number();
      const double high = branch == "range" ? (expect(","), number()) : low;
      expect(")");
      taken = wanted >= low && wanted <= high;
    }
    if (taken) return push(Block::kSwitch);
  }
}

void PovInterpreter::obey_break() {
  std::vector<Block>& blocks = here().blocks;
  while (!blocks.empty()) {
    while (skip_branch() != "end") continue;
    const Block::Kind left = blocks.back().kind;
    blocks.pop_back();
    if (left == Block::kMacro) {
      cursors_.pop_back();
      return;
    }
    if (left != Block::kIf) return;
  }
  fail("found #break outside a block");
}

void PovInterpreter::obey_end() {
  std::vector<Block>& blocks = here().blocks;
  if (blocks.empty()) fail("found #end outside a block");
  Block& block = blocks.back();
  if (block.kind == Block::kMacro) {
    cursors_.pop_back();
  } else if (block.kind == Block::kWhile) {
    here().next = block.start;
    blocks.pop_back();
    obey_while();
  } else if (block.kind == Block::kFor) {
    count_step();
    block.value += block.step;
    // With room for rounding, as in POV-Ray.
    const bool runs = block.step > 0 ? block.value < block.last + 1e-10 * std::max(1.0, std::abs(block.last))
                                     : block.value > block.last - 1e-10 * std::max(1.0, std::abs(block.last));
    if (!runs) return blocks.pop_back();
    here().next = block.start;
    declare(block.variable, number_of(block.value), true);
  } else {
    blocks.pop_back();
  }
}

std::string PovInterpreter::found_include(const std::string& name) const {
  std::vector<std::string> candidates{path_beside(cursors_.back().file->path, name),
                                      path_beside(cursors_.front().file->path, name), name};
  for (const std::string& folder : run_.library_path) candidates.push_back(folder + "/" + name);
  for (const char* folder : {"/usr/share/povray-3.7/include/", "/usr/local/share/povray-3.7/include/"})
    candidates.push_back(folder + name);
  for (const std::string& path : candidates)
    if (std::filesystem::is_regular_file(path)) return path;
  return "";
}

void PovInterpreter::obey_include() {
  const PovPlace from = place();
  const std::string name = string();
  const std::string path = found_include(name);
  if (!path.empty()) return open(path);
  const std::string what = "included file " + in_quotes(name, name.size()) + " is missing";
  refuse_missing(what, from.file, from.line, options_, report_);
}

// Only remembers where the body begins. Its tokens are read at each call.
void PovInterpreter::obey_macro() {
  PovMacro macro;
  macro.file = here().file;
  const auto take_raw = [this](PovKind kind, std::string_view text, const std::string& expected) {
    if (raw().kind != kind || (!text.empty() && raw().text != text)) fail_expected(expected);
    return std::string(here().file->tokens[here().next++].text);
  };
  const std::string name = take_raw(PovKind::kWord, "", "the name of the macro");
  take_raw(PovKind::kSymbol, "(", "(");
  while (!(raw().kind == PovKind::kSymbol && raw().text == ")")) {
    macro.parameters.push_back(take_raw(PovKind::kWord, "", "the name of a parameter"));
    if (raw().kind == PovKind::kSymbol && raw().text == ",") ++here().next;
  }
  ++here().next;
  macro.body = here().next;
  while (skip_branch() != "end") continue;
  declare(name, std::move(macro), false);
}

// Called at the macro's name.
void PovInterpreter::call(PovMacro macro) {
  const Deeper deeper(this);
  count_step();
  if (cursors_.size() >= kMaxNesting) fail("includes and macros are nested too deep");
  const std::string name(raw().text);
  ++here().next;
  Cursor inside;
  inside.file = macro.file;
  inside.next = macro.body;
  expect("(");
  for (size_t i = 0; i < macro.parameters.size(); ++i) {
    if (i > 0 && !take_if(",")) fail_expected("argument " + std::to_string(i + 1) + " of " + name);
    inside.locals.insert_or_assign(macro.parameters[i], value());
  }
  expect(")");
  Block block;
  block.kind = Block::kMacro;
  block.line = raw().line;
  inside.blocks.push_back(block);
  cursors_.push_back(std::move(inside));
}

}  // namespace strad
