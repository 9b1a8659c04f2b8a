// POV-Ray's conditions and loops: directives that choose and repeat blocks.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {
namespace {

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
    count_token();
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

void PovInterpreter::count_token() { count_words(1); }

void PovInterpreter::count_words(double words) {
  words_ += words;
  if (words_ > static_cast<double>(run_.most_words))
    fail("the file takes more than " + std::to_string(run_.most_words) + " words");
}

void PovInterpreter::count_step() {
  if (++steps_ > run_.most_steps)
    fail("the file takes more than " + std::to_string(run_.most_steps) + " turns of loops");
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

}  // namespace strad
