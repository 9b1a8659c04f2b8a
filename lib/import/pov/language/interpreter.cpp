// The sequence of tokens, across includes and macros, and the names that are declared.
#include "import/pov/language/interpreter.h"

#include <algorithm>

#include "base/text.h"

namespace strad {

void refuse(const PovProblem& problem, const SkipOptions& options, ImportReport* report) {
  if (!options.skip_unknown)
    fail_at(problem.place.file, problem.place.line, problem.what + " is not supported");
  report->add(problem.what + " left out", problem.place.file, problem.place.line);
}

PovInterpreter::PovInterpreter(const SkipOptions& options, const PovRun& run, PovFiles* files,
                               ImportReport* report, PovStatements* statements)
    : options_(options), run_(run), files_(files), report_(report), statements_(statements) {
  numbers_ = {{"pi", kPi},
              {"true", 1},
              {"false", 0},
              {"on", 1},
              {"off", 0},
              {"yes", 1},
              {"no", 0},
              {"clock", run.clock},
              {"clock_delta", run.clock_delta},
              {"clock_on", run.clock_on ? 1 : 0},
              {"version", 3.7},
              {"frame_number", run.frame_number},
              {"image_width", run.image_width},
              {"image_height", run.image_height},
              {"initial_frame", run.initial_frame},
              {"final_frame", run.final_frame},
              {"initial_clock", run.initial_clock},
              {"final_clock", run.final_clock}};
  for (const auto& [name, value] : run.declared) {
    if (const auto* number = std::get_if<double>(&value))
      globals_.insert_or_assign(name, number_of(*number));
    else
      globals_.insert_or_assign(name, std::get<std::string>(value));
  }
}

void PovInterpreter::open(const std::string& path) {
  if (cursors_.size() >= kMaxNesting) fail("includes and macros are nested too deep");
  std::shared_ptr<const PovFile>& file = (*files_)[path];
  if (!file) file = read_pov_file(path);
  cursors_.emplace_back().file = file;
}

const PovToken& PovInterpreter::peek() {
  while (true) {
    Cursor& cursor = here();
    const PovToken& token = raw();
    if (cursor.plain == cursor.next) return token;
    if (token.kind == PovKind::kDirective) {
      obey();
    } else if (token.kind == PovKind::kEnd) {
      if (!cursor.blocks.empty())
        fail_at(cursor.file->name, cursor.blocks.back().line, "the block is not closed, expected #end");
      if (cursors_.size() == 1) return token;
      cursors_.pop_back();
    } else {
      const PovValue* known = token.kind == PovKind::kWord ? find(token.text) : nullptr;
      if (known && std::holds_alternative<PovMacro>(*known)) {
        call(std::get<PovMacro>(*known));
        continue;
      }
      cursor.plain = cursor.next;
      return token;
    }
  }
}

PovToken PovInterpreter::take() {
  const PovToken token = peek();
  count_token();
  if (token.kind != PovKind::kEnd) ++here().next;
  return token;
}

bool PovInterpreter::next_is(std::string_view text) {
  const PovToken& token = peek();
  return (token.kind == PovKind::kSymbol || token.kind == PovKind::kWord) && token.text == text;
}

bool PovInterpreter::next_is_plainly(std::string_view text) {
  return (raw().kind == PovKind::kWord || raw().kind == PovKind::kSymbol) && raw().text == text;
}

bool PovInterpreter::take_if(std::string_view text) {
  if (!next_is(text)) return false;
  ++here().next;
  return true;
}

void PovInterpreter::expect(std::string_view symbol) {
  if (!take_if(symbol)) fail_expected(std::string(symbol));
}

void PovInterpreter::skip_block() {
  const PovPlace start = place();
  expect("{");
  for (int depth = 1; depth > 0;) {
    const PovToken token = take();
    if (token.kind == PovKind::kEnd) fail_at(start.file, start.line, "the block is not closed, expected }");
    if (token.kind == PovKind::kSymbol && token.text == "{") ++depth;
    if (token.kind == PovKind::kSymbol && token.text == "}") --depth;
  }
}

void PovInterpreter::skip_item() {
  take();
  for (int brackets = 0;;) {
    const PovToken& token = peek();
    if (next_is("{")) return skip_block();
    if (next_is("}") || token.kind == PovKind::kEnd) return;
    if (next_is("]") && brackets == 0) return;  // of the map that the item is in
    if (token.kind == PovKind::kWord && !expression_is_next()) return;
    if (token.kind == PovKind::kSymbol) brackets += token.text == "[" ? 1 : token.text == "]" ? -1 : 0;
    take();
  }
}

PovPlace PovInterpreter::place_of(const PovToken& token) const {
  return {cursors_.back().file->name, token.line};
}
PovPlace PovInterpreter::place() { return place_of(peek()); }

void PovInterpreter::fail(const std::string& what) { fail_at(here().file->name, raw().line, what); }

void PovInterpreter::fail_expected(const std::string& expected) {
  const PovToken& token = raw();
  const std::string found = token.kind == PovKind::kEnd         ? "the end of the file"
                            : token.kind == PovKind::kDirective ? "#" + std::string(token.text)
                                                                : in_quotes(token.text);
  fail("found " + found + ", expected " + expected);
}

const PovValue* PovInterpreter::find(std::string_view name) const {
  for (auto cursor = cursors_.rbegin(); cursor != cursors_.rend(); ++cursor) {
    if (const auto found = cursor->locals.find(name); found != cursor->locals.end()) return &found->second;
    if (!cursor->names) continue;
    if (const auto found = cursor->names->values.find(name); found != cursor->names->values.end())
      return &found->second;
  }
  const auto found = globals_.find(name);
  return found == globals_.end() ? nullptr : &found->second;
}

void PovInterpreter::set(const std::string& name, const PovNumbers& value) { declare(name, value, false); }

// #declare gives a new value to the name that is in scope, be it local, as POV-Ray's Parse_Declare does; a
// name that is not in scope becomes global.
void PovInterpreter::declare(const std::string& name, PovValue value, bool local, size_t level) {
  if (level == 0 || level > cursors_.size()) level = cursors_.size();
  auto* names = local ? &cursors_[level - 1].locals : &globals_;
  for (size_t i = level; !local && i > 0; --i) {
    if (!cursors_[i - 1].locals.contains(name)) continue;
    names = &cursors_[i - 1].locals;
    break;
  }
  names->insert_or_assign(name, std::move(value));
}

void PovInterpreter::charge(size_t bytes) {
  if (bytes > run_.most_bytes - made_)
    fail("the file makes more than " + std::to_string(run_.most_bytes / 1'000'000) +
         " MB of strings, arrays and objects");
  made_ += bytes;
}

}  // namespace strad
