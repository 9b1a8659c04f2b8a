// Files that a POV-Ray file opens: read if they lie in its folder or below; what is written stays in memory.
#include <array>
#include <cstdio>
#include <filesystem>

#include "base/error.h"
#include "base/text.h"
#include "import/pov/language/interpreter.h"

namespace strad {
namespace {

std::string unescaped(const std::string& text) {
  std::string plain;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      plain += text[i];
      continue;
    }
    const char c = text[++i];
    plain += c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c;
  }
  return plain;
}

// With all digits, so that they are the same when they are read again.
std::string written_numbers(const PovNumbers& numbers) {
  std::string text;
  for (int i = 0; i < numbers.size; ++i) {
    std::array<char, 32> part;
    std::snprintf(part.data(), part.size(), "%.17g", numbers[i]);
    text += (i ? "," : "") + std::string(part.data());
  }
  return numbers.size == 1 ? text : "<" + text + ">";
}

}  // namespace

// NAME "file" read, write or append
void PovInterpreter::obey_fopen() {
  const PovPlace at{here().file->name, raw().line};
  if (raw().kind != PovKind::kWord) fail_expected("a name for the file");
  const std::string name(raw().text);
  ++here().next;
  const std::string path = string();
  if (!take_if("read")) {
    const bool append = take_if("append");
    if (!append && !take_if("write")) fail_expected("read, write or append");
    report_->add("#fopen for writing: no file is written, only the scene itself can read it again", at.file,
                 at.line);
    if (!append) written_[path].clear();
    open_files_[name] = {nullptr, 0, path};
    return;
  }
  if (const auto own = written_.find(path); own != written_.end()) {
    open_files_[name] = {pov_file_of(own->second, path), 0, ""};
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
  open_files_[name] = {file, 0, ""};
}

bool PovInterpreter::is_exhausted(std::string_view name) const {
  const auto open = open_files_.find(name);
  return open == open_files_.end() || !open->second.file ||
         open->second.file->tokens[open->second.next].kind == PovKind::kEnd;
}

// The next number, vector or string of a file of such things with commas between.
PovValue PovInterpreter::value_in(OpenFile* from, const std::string& name) {
  if (!from->written.empty())
    fail("the file " + name + " is open for writing, so nothing can be read from it");
  if (!from->file) {  // missing, with skip_missing
    report_->add("what is read from a missing file is taken as 0", here().file->name, raw().line);
    return number_of(0);
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
  if (!open_files_.contains(name))
    fail("found " + in_quotes(name) + ", expected a file that #fopen has opened");
  ++here().next;
  take_if(",");
  while (!take_if(")")) {
    if (raw().kind != PovKind::kWord) fail_expected("the name of a variable");
    const std::string variable(raw().text);
    ++here().next;
    // Sought again for each value: a macro in an index can close the file.
    const auto open = open_files_.find(name);
    if (open == open_files_.end()) fail("the file " + name + " has been closed while it is read");
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

// (NAME, values): strings without their quotes, numbers and vectors as they are read.
void PovInterpreter::obey_write() {
  expect("(");
  const std::string name(raw().text);
  const auto open = open_files_.find(name);
  if (open == open_files_.end() || open->second.written.empty())
    fail("found " + in_quotes(name) + ", expected a file that #fopen has opened for writing");
  std::string& text = written_[open->second.written];
  ++here().next;
  take_if(",");
  while (!take_if(")")) {
    // A macro in a value can empty the file, so each part is counted by itself.
    const std::string part = string_is_next() ? unescaped(string()) : written_numbers(numbers());
    charge(part.size());
    text += part;
    skip_comma();
  }
}

}  // namespace strad
