// POV-Ray's directives: what is declared, included, called.
#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {
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
  } else if (name == "fopen") {
    obey_fopen();
  } else if (name == "read") {
    obey_read();
  } else if (name == "write") {
    obey_write();
  } else if (name == "fclose") {
    open_files_.erase(std::string(raw().text));
    ++here().next;
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
  const size_t level = cursors_.size();  // a macro that gives the value has not ended when its value has
  expect("=");
  PovValue declared = kept(value());
  if (auto* thing = std::get_if<std::any>(&declared)) statements_->name_declared(name, thing);
  declare(name, std::move(declared), local, level);
  if (next_is_plainly(";")) take();
}

std::string PovInterpreter::found_include(const std::string& name) const {
  std::vector<std::string> candidates{path_beside(cursors_.back().file->path, name),
                                      path_beside(cursors_.front().file->path, name), name};
  for (const std::string& folder : run_.library_path) candidates.push_back(folder + "/" + name);
  for (const char* folder : {"/usr/share/povray-3.7/include/", "/usr/local/share/povray-3.7/include/"})
    candidates.push_back(folder + name);
  for (const std::string& path : candidates)
    if (is_plain_file(path)) return path;
  return "";
}

void PovInterpreter::obey_include() {
  const PovPlace from = place();
  const std::string name = string();
  if (const auto own = written_.find(name); own != written_.end()) {
    if (cursors_.size() >= kMaxNesting) fail("includes and macros are nested too deep");
    cursors_.emplace_back().file = pov_file_of(own->second, name);
    return;
  }
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
    // POV-Ray does without commas, too.
    if (i > 0 && !take_if(",") && next_is(")"))
      fail_expected("argument " + std::to_string(i + 1) + " of " + name);
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
