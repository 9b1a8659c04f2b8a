// Reads an OBJ file strictly, before tinyobjloader does.
#include "import/obj/scan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

#include "base/error.h"
#include "base/text.h"
#include "import/polygonize.h"

namespace strad {
namespace {

constexpr size_t kMaxItems = 0x7fffffff;  // indices are 31 bits in tinyobjloader

// Statements that say nothing about polygons: display, skinning, subdivision.
bool is_without_meaning(std::string_view word) {
  return is_one_of(word, {"mg", "bevel", "c_interp", "d_interp", "lod", "maplib", "usemap", "shadow_obj",
                          "ctech", "trace_obj", "stech", "vw", "t", "vp", "csh", "end"});
}

// Statements of free-form curves and surfaces.
bool is_free_form(std::string_view word) {
  return is_one_of(word, {"cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole",
                          "scrv", "sp", "con", "bzp", "bsp", "cdc", "res"});
}

// Names in order of first use.
class NameList {
 public:
  explicit NameList(std::vector<ObjScan::Named>* list) : list_(list) {}
  size_t place_of(const std::string& name, uint32_t line) {
    const auto [found, is_new] = place_.insert({name, list_->size()});
    if (is_new) list_->push_back({name, line});
    return found->second;
  }

 private:
  std::vector<ObjScan::Named>* list_;
  std::unordered_map<std::string, size_t> place_;
};

// Counts vertices or texture coordinates, and resolves references to them. A reference may come before what
// it refers to.
class Numbered {
 public:
  Numbered(std::string what, const std::string& file) : what_(std::move(what)), file_(file) {}

  void add(uint32_t line) {
    if (++count_ > kMaxItems) fail_at(file_, line, "too many of " + what_);
  }
  size_t count() const { return count_; }

  // Absolute index from 1.
  size_t resolve(std::string_view word, uint32_t line) {
    const auto index = integer_in(word);
    if (!index) fail_at(file_, line, "found " + in_quotes(word) + ", expected the number of a " + what_);
    if (*index == 0) fail_at(file_, line, "face uses " + what_ + " 0, but they count from 1");
    const auto count = static_cast<int64_t>(count_);
    if (*index < -count || *index > static_cast<int64_t>(kMaxItems)) refuse(*index, line);
    if (*index < 0) return static_cast<size_t>(count + *index + 1);
    if (*index > furthest_) furthest_ = *index, furthest_line_ = line;
    return static_cast<size_t>(*index);
  }
  void finish() const {
    if (furthest_ > static_cast<int64_t>(count_)) refuse(furthest_, furthest_line_);
  }

 private:
  [[noreturn]] void refuse(int64_t index, uint32_t line) const {
    fail_at(file_, line,
            "face uses " + what_ + " " + std::to_string(index) + " of " + std::to_string(count_));
  }
  std::string what_;
  const std::string& file_;
  size_t count_ = 0;
  int64_t furthest_ = 0;
  uint32_t furthest_line_ = 0;
};

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name, const ImportOptions& options, ImportReport* report)
      : lines_(text), name_(name), options_(options), report_(report) {
    scan_.clean.reserve(text.size());
  }
  ObjScan run();

 private:
  void statement(std::string_view word, std::string_view rest);
  size_t numbers(std::string_view word, std::string_view rest, size_t least, size_t most, size_t kept);
  void vertex(std::string_view rest);
  void face(std::string_view rest);
  void corner(std::string_view word);
  void normal(std::string_view word, bool after_uv);
  void smoothing(std::string_view rest);
  void name_object();
  void left_out(const std::string& what) { report_->add(what + " left out", name_, lines_.number()); }
  void put(std::string_view word) { scan_.clean.append(word); }
  void put(size_t number) {
    std::array<char, 24> digits;
    put({digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr});
  }

  LineReader lines_;
  const std::string& name_;
  const ImportOptions& options_;
  ImportReport* report_;
  ObjScan scan_;
  NameList objects_{&scan_.objects}, materials_{&scan_.materials};
  Numbered vertices_{"vertex", name_}, uvs_{"texture coordinate", name_};
  uint32_t group_of_faces_ = 0;  // for smoothing
  std::string object_, group_, material_;
  bool object_changed_ = true, material_changed_ = true;
};

// Checks all numbers, copies the first `kept`, and returns how many there are. A comment may follow them.
size_t Scanner::numbers(std::string_view word, std::string_view rest, size_t least, size_t most,
                        size_t kept) {
  size_t count = 0;
  for (std::string_view text = next_word(&rest); !text.empty() && !text.starts_with('#');
       text = next_word(&rest)) {
    if (!number_in(text))
      fail_at(name_, lines_.number(), "found " + in_quotes(text) + ", expected a finite number");
    if (count++ >= kept) continue;
    put(count == 1 ? word : "");
    put(" ");
    put(text.starts_with('+') ? text.substr(1) : text);
  }
  if (kept > 0) put("\n");
  if (count >= least && count <= most) return count;
  const std::string expected = std::to_string(least) + (most > least ? " to " + std::to_string(most) : "");
  fail_at(name_, lines_.number(),
          std::string(word) + " has " + std::to_string(count) + " numbers, expected " + expected);
}

// x y z; some files have a weight or a colour after them.
void Scanner::vertex(std::string_view rest) {
  if (numbers("v", rest, 3, 7, 3) >= 6) left_out("vertex colour");
  vertices_.add(lines_.number());
}

void Scanner::corner(std::string_view word) {
  const size_t first = std::min(word.find('/'), word.size());
  put(" ");
  put(vertices_.resolve(word.substr(0, first), lines_.number()));
  if (first == word.size()) return;
  const std::string_view rest = word.substr(first + 1);
  const size_t second = std::min(rest.find('/'), rest.size());
  if (second > 0) {
    put("/");
    put(uvs_.resolve(rest.substr(0, second), lines_.number()));
  }
  if (second + 1 < rest.size()) normal(rest.substr(second + 1), second > 0);
}

// Some programs leave normals out while faces still refer to them, always to ones before.
void Scanner::normal(std::string_view word, bool after_uv) {
  const auto index = integer_in(word);
  if (!index)
    fail_at(name_, lines_.number(), "found " + in_quotes(word) + ", expected the number of a normal");
  const auto count = static_cast<int64_t>(scan_.normal_count);
  if (*index == 0 || *index < -count || *index > count)
    return report_->add("face uses a normal that is not there", name_, lines_.number());
  put(after_uv ? "/" : "//");
  put(static_cast<size_t>(*index < 0 ? count + *index + 1 : *index));
}

void Scanner::smoothing(std::string_view rest) {
  const std::string_view text = next_word(&rest);
  const auto number = integer_in(text);
  if (text == "off" || text == "on") {
    group_of_faces_ = text == "on" ? 1 : 0;
  } else if (number && *number >= 0 && *number <= static_cast<int64_t>(kMaxItems)) {
    group_of_faces_ = static_cast<uint32_t>(*number);
  } else {
    fail_at(name_, lines_.number(), "found s " + in_quotes(text) + ", expected off or the number of a group");
  }
}

void Scanner::face(std::string_view rest) {
  const size_t begin = scan_.clean.size();
  if (object_changed_) name_object();
  if (material_changed_) {
    put("usemtl ");
    put(materials_.place_of(material_, lines_.number()));
    put("\n");
  }
  put("f");
  size_t count = 0;
  for (std::string_view word = next_word(&rest); !word.empty() && !word.starts_with('#');
       word = next_word(&rest)) {
    corner(word);
    ++count;
  }
  put("\n");
  if (count > kMaxCorners)
    fail_at(
        name_, lines_.number(),
        "face has " + std::to_string(count) + " corners, expected at most " + std::to_string(kMaxCorners));
  if (count < 3) {
    scan_.clean.resize(begin);
    return left_out("degenerate face");
  }
  object_changed_ = material_changed_ = false;
  scan_.face_lines.push_back(lines_.number());
  scan_.face_groups.push_back(group_of_faces_);
}

void Scanner::name_object() {
  const bool both = !object_.empty() && !group_.empty() && object_ != group_;
  const std::string full = both ? object_ + "/" + group_ : object_.empty() ? group_ : object_;
  put("o ");
  put(objects_.place_of(full.empty() ? "unnamed" : full, lines_.number()));
  put("\n");
}

void Scanner::statement(std::string_view word, std::string_view rest) {
  if (word == "v") return vertex(rest);
  if (word == "f" || word == "fo") return face(rest);
  if (word == "vt") {
    numbers("vt", rest, 1, 3, 2);
    return uvs_.add(lines_.number());
  }
  if (word == "vn") {
    numbers("vn", rest, 3, 3, 3);
    ++scan_.normal_count;
    return;
  }
  if (word == "s") return smoothing(rest);
  if (word == "o" || word == "g") {
    if (word == "o") object_ = single_spaced(rest), group_.clear();
    if (word == "g") group_ = single_spaced(rest);
    object_changed_ = true;
  } else if (word == "usemtl") {
    material_ = single_spaced(rest);
    material_changed_ = true;
  } else if (word == "mtllib") {
    if (trimmed(rest).empty()) fail_at(name_, lines_.number(), "mtllib names no file");
    scan_.libraries.push_back({std::string(trimmed(rest)), lines_.number()});
  } else if (word == "l" || word == "p") {
    left_out(word == "l" ? "line" : "point");
  } else if (is_free_form(word)) {
    if (word == "curv" || word == "curv2" || word == "surf") left_out("free-form " + std::string(word));
  } else if (!is_without_meaning(word)) {
    if (!options_.skip_unknown)
      fail_at(name_, lines_.number(),
              "found " + in_quotes(word) + ", expected an OBJ statement such as v, f or usemtl");
    left_out("unknown statement " + in_quotes(word));
  }
}

ObjScan Scanner::run() {
  while (lines_.next()) {
    std::string_view rest = lines_.line();
    const std::string_view word = next_word(&rest);
    if (!word.empty() && !word.starts_with('#')) statement(word, rest);
  }
  vertices_.finish();
  uvs_.finish();
  scan_.vertex_count = vertices_.count();
  scan_.uv_count = uvs_.count();
  return std::move(scan_);
}

}  // namespace

ObjScan scan_obj(std::string_view text, const std::string& name, const ImportOptions& options,
                 ImportReport* report) {
  return Scanner(text, name, options, report).run();
}

}  // namespace strad
