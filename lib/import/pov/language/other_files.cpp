// Files that a POV-Ray file opens: read if they lie in its folder or below, never written.
#include <filesystem>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {

// NAME "file" read, write or append
void PovInterpreter::obey_fopen() {
  const PovPlace at{here().file->name, raw().line};
  if (raw().kind != PovKind::kWord) fail_expected("a name for the file");
  const std::string name(raw().text);
  ++here().next;
  const std::string path = string();
  if (!take_if("read")) {
    if (!take_if("write") && !take_if("append")) fail_expected("read, write or append");
    refuse({"#fopen for writing", at}, options_, report_);
    open_files_[name] = {};
    return;
  }
  const std::filesystem::path relative(path);
  bool leaves = relative.is_absolute();
  for (const auto& part : relative) leaves = leaves || part == "..";
  if (leaves)
    fail_at(at.file, at.line, "#fopen of " + in_quotes(path) + ", which is not below the scene's folder");
  const std::string found = path_beside(cursors_.front().file->path, path);
  if (!std::filesystem::is_regular_file(found)) {
    refuse_missing("file " + in_quotes(path) + " is missing", at.file, at.line, options_, report_);
    open_files_[name] = {};
    return;
  }
  std::shared_ptr<const PovFile>& file = (*files_)[found];
  if (!file) file = read_pov_file(found);
  open_files_[name] = {file, 0};
}

bool PovInterpreter::is_exhausted(std::string_view name) const {
  const auto open = open_files_.find(name);
  return open == open_files_.end() || !open->second.file ||
         open->second.file->tokens[open->second.next].kind == PovKind::kEnd;
}

// The next number, vector or string of a file of such things with commas between.
PovValue PovInterpreter::value_in(OpenFile* from, const std::string& name) {
  if (!from->file) {
    fail("the file " + name + " was left out, so nothing can be read from it");
  }
  const auto& tokens = from->file->tokens;
  const auto bad = [&]() {
    const PovToken& token = tokens[from->next];
    const std::string found = token.kind == PovKind::kEnd ? "the end of the file" : in_quotes(token.text);
    fail_at(from->file->name, token.line, "found " + found + ", expected a number, a vector or a string");
  };
  const auto symbol = [&](std::string_view text) {
    if (tokens[from->next].kind != PovKind::kSymbol || tokens[from->next].text != text) return false;
    ++from->next;
    return true;
  };
  const auto read_number = [&]() {
    double sign = 1;
    while (symbol("-")) sign = -sign;
    if (tokens[from->next].kind != PovKind::kNumber) bad();
    return sign * tokens[from->next++].number;
  };
  PovValue result;
  if (tokens[from->next].kind == PovKind::kString) {
    result = std::string(tokens[from->next++].text);
  } else if (symbol("<")) {
    PovNumbers vector;
    vector.size = 0;
    while (!symbol(">")) {
      if (vector.size == 5) bad();
      vector[vector.size++] = read_number();
      symbol(",");
    }
    result = vector;
  } else {
    result = number_of(read_number());
  }
  symbol(",");
  return result;
}

// (NAME, variable, ...)
void PovInterpreter::obey_read() {
  expect("(");
  const std::string name(raw().text);
  const auto open = open_files_.find(name);
  if (open == open_files_.end())
    fail("found " + in_quotes(name) + ", expected a file that #fopen has opened");
  ++here().next;
  take_if(",");
  while (!take_if(")")) {
    if (raw().kind != PovKind::kWord) fail_expected("the name of a variable");
    const std::string variable(raw().text);
    ++here().next;
    PovValue read = value_in(&open->second, name);
    if (next_is("[")) {
      const PovValue* known = find(variable);
      if (!known || !std::holds_alternative<std::shared_ptr<PovArray>>(*known))
        fail(variable + " is not an array");
      const auto array = std::get<std::shared_ptr<PovArray>>(*known);
      array->items[indices_into(*array, variable)] = std::move(read);
    } else {
      declare(variable, std::move(read), here().locals.contains(variable));
    }
    skip_comma();
  }
}

// (NAME, values): ignored, for #fopen has refused or reported it.
void PovInterpreter::obey_write() {
  expect("(");
  for (int depth = 1; depth > 0;) {
    const PovToken token = take();
    if (token.kind == PovKind::kEnd) fail_expected(")");
    if (token.kind == PovKind::kSymbol && token.text == "(") ++depth;
    if (token.kind == PovKind::kSymbol && token.text == ")") --depth;
  }
}

}  // namespace strad
