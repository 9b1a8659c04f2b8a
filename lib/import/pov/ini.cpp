#include "import/pov/ini.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"

namespace strad {
namespace {

constexpr int kMostFrames = 1'000'000;
constexpr int kMostPixels = 1'000'000;

// Settings of POV-Ray 3.7 that change no geometry and no light.
constexpr std::array kIgnored{"all_console",
                              "all_file",
                              "antialias",
                              "antialias_depth",
                              "antialias_gamma",
                              "antialias_threshold",
                              "append_file",
                              "bits_per_color",
                              "bits_per_colour",
                              "bounding",
                              "bounding_method",
                              "bounding_threshold",
                              "bsp_basecost",
                              "bsp_childcost",
                              "bsp_isectcost",
                              "bsp_maxdepth",
                              "bsp_missratio",
                              "buffer_output",
                              "buffer_size",
                              "compression",
                              "continue_trace",
                              "create_continue_trace_log",
                              "create_ini",
                              "debug_console",
                              "debug_file",
                              "display",
                              "display_gamma",
                              "dither",
                              "dither_method",
                              "draw_vistas",
                              "end_column",
                              "end_row",
                              "fatal_console",
                              "fatal_error_command",
                              "fatal_error_return",
                              "fatal_file",
                              "field_render",
                              "file_gamma",
                              "grayscale_output",
                              "high_reproducibility",
                              "histogram_grid_size",
                              "histogram_name",
                              "histogram_type",
                              "include_header",
                              "include_ini",
                              "jitter",
                              "jitter_amount",
                              "light_buffer",
                              "max_image_buffer_memory",
                              "odd_field",
                              "output_alpha",
                              "output_file_name",
                              "output_file_type",
                              "output_to_file",
                              "palette",
                              "pause_when_done",
                              "post_frame_command",
                              "post_frame_return",
                              "post_scene_command",
                              "post_scene_return",
                              "pre_frame_command",
                              "pre_frame_return",
                              "pre_scene_command",
                              "pre_scene_return",
                              "preview_end_size",
                              "preview_start_size",
                              "quality",
                              "radiosity_file_name",
                              "radiosity_from_file",
                              "radiosity_to_file",
                              "radiosity_vain_pretrace",
                              "real_time_raytracing",
                              "remove_bounds",
                              "render_block_size",
                              "render_block_step",
                              "render_console",
                              "render_file",
                              "render_pattern",
                              "sampling_method",
                              "split_unions",
                              "start_column",
                              "start_row",
                              "statistic_console",
                              "statistic_file",
                              "stochastic_seed",
                              "test_abort",
                              "test_abort_count",
                              "user_abort_command",
                              "user_abort_return",
                              "verbose",
                              "version",
                              "video_mode",
                              "vista_buffer",
                              "warning_console",
                              "warning_file",
                              "warning_level",
                              "work_threads"};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

std::string_view without_quotes(std::string_view text) {
  const bool quoted =
      text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front();
  return quoted ? text.substr(1, text.size() - 2) : text;
}

class IniReader {
 public:
  IniReader(const std::string& path, const SkipOptions& options, ImportReport* report)
      : path_(path), file_(text_name(path)), options_(options), report_(report) {}

  PovIni read();

 private:
  void setting(std::string_view name, std::string_view value);
  void command_line_switch(std::string_view word);
  void declare(std::string_view assignment);
  void finish();
  [[noreturn]] void fail(const std::string& what) const { fail_at(file_, line_, what); }
  double number(std::string_view name, std::string_view value) const;
  int whole(std::string_view name, std::string_view value, int least, int most) const;
  bool truth(std::string_view name, std::string_view value) const;
  int frame_or_part(std::string_view text) const;

  const std::string& path_;
  const std::string file_;
  const SkipOptions& options_;
  ImportReport* report_;
  uint32_t line_ = 0, ignored_line_ = 0;
  PovIni ini_;
  std::string subset_start_, subset_end_;
  std::optional<double> clock_;
};

double IniReader::number(std::string_view name, std::string_view value) const {
  const std::optional<double> number = number_in(value);
  if (!number) fail(std::string(name) + " is " + in_quotes(value) + ", expected a number");
  return *number;
}

int IniReader::whole(std::string_view name, std::string_view value, int least, int most) const {
  const std::optional<int64_t> number = integer_in(value);
  if (!number || *number < least || *number > most)
    fail(std::string(name) + " is " + in_quotes(value) + ", expected a whole number from " +
         std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(*number);
}

bool IniReader::truth(std::string_view name, std::string_view value) const {
  const std::string word = lower(value);
  if (is_one_of(word, {"on", "true", "yes", "1"})) return true;
  if (!is_one_of(word, {"off", "false", "no", "0"}))
    fail(std::string(name) + " is " + in_quotes(value) + ", expected on or off");
  return false;
}

// A frame, or below 1 a part of the final frame, rounded down but not before the initial one, as POV-Ray 3.7
// takes it.
int IniReader::frame_or_part(std::string_view text) const {
  const PovAnimation& a = ini_.animation;
  const double value = number("a subset's frame", text);
  const double frame = value < 1 ? std::max(std::floor(value * a.final_frame), 1.0 * a.initial_frame) : value;
  if (!(frame >= a.initial_frame && frame <= a.final_frame))
    fail("the subset has frame " + std::string(text) + ", expected " + std::to_string(a.initial_frame) +
         " to " + std::to_string(a.final_frame));
  return static_cast<int>(std::lround(frame));
}

void IniReader::declare(std::string_view assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0)
    fail("Declare is " + in_quotes(assignment) + ", expected NAME=VALUE");
  const std::string name(trimmed(assignment.substr(0, equals)));
  const std::string_view value = trimmed(assignment.substr(equals + 1));
  if (const std::optional<double> number = number_in(value))
    ini_.animation.run.declared.emplace_back(name, *number);
  else
    ini_.animation.run.declared.emplace_back(name, std::string(without_quotes(value)));
}

void IniReader::setting(std::string_view name, std::string_view value) {
  const std::string key = lower(name);
  PovAnimation& a = ini_.animation;
  if (key == "input_file_name") {
    // Beside the .ini file, else in the working directory, where POV-Ray looks.
    const std::string scene(without_quotes(value));
    ini_.scene = path_beside(path_, scene);
    if (!file_exists(ini_.scene) && file_exists(scene)) ini_.scene = scene;
  } else if (key == "initial_frame") {
    a.initial_frame = whole(name, value, 0, kMostFrames);
  } else if (key == "final_frame") {
    a.final_frame = whole(name, value, 0, kMostFrames);
    a.moves = true;
  } else if (key == "initial_clock") {
    a.initial_clock = number(name, value);
  } else if (key == "final_clock") {
    a.final_clock = number(name, value);
  } else if (key == "clock") {
    clock_ = number(name, value);
  } else if (key == "cyclic_animation") {
    a.cyclic = truth(name, value);
  } else if (key == "subset_start_frame") {
    subset_start_ = value;
  } else if (key == "subset_end_frame") {
    subset_end_ = value;
  } else if (key == "width") {
    a.run.image_width = whole(name, value, 1, kMostPixels);
  } else if (key == "height") {
    a.run.image_height = whole(name, value, 1, kMostPixels);
  } else if (key == "declare") {
    declare(value);
  } else if (key == "library_path") {
    a.run.library_path.push_back(path_beside(path_, std::string(without_quotes(value))));
  } else if (key == "frame_step" || key == "clockless_animation") {
    fail(std::string(name) + " is not supported");
  } else if (std::find(kIgnored.begin(), kIgnored.end(), key) != kIgnored.end()) {
    if (ignored_line_ == 0) ignored_line_ = line_;
  } else if (options_.skip_unknown) {
    report_->add("setting " + in_quotes(name) + " left out", file_, line_);
  } else {
    fail("found setting " + in_quotes(name) + ", which POV-Ray 3.7 does not have");
  }
}

// Those of a command line that have a meaning here: +Iscene.pov, +W320, +KFF250, ...
void IniReader::command_line_switch(std::string_view word) {
  const std::string key = lower(word.substr(1));
  struct Switch {
    std::string_view letters, name;
  };
  constexpr Switch kSwitches[] = {{"kff", "final_frame"},
                                  {"kfi", "initial_frame"},
                                  {"kf", "final_clock"},
                                  {"ki", "initial_clock"},
                                  {"kc", "cyclic_animation"},
                                  {"sf", "subset_start_frame"},
                                  {"ef", "subset_end_frame"},
                                  {"k", "clock"},
                                  {"i", "input_file_name"},
                                  {"w", "width"},
                                  {"h", "height"},
                                  {"l", "library_path"}};
  for (const Switch& known : kSwitches) {
    if (!key.starts_with(known.letters)) continue;
    const std::string_view value = word.substr(1 + known.letters.size());
    return setting(known.name, known.name == "cyclic_animation" ? (word[0] == '+' ? "on" : "off") : value);
  }
  if (ignored_line_ == 0) ignored_line_ = line_;
}

void IniReader::finish() {
  PovAnimation& a = ini_.animation;
  if (ini_.scene.empty()) fail_at(file_, line_, "found no Input_File_Name, expected the scene's");
  a.run.clock = clock_.value_or(0);
  a.run.clock_on = clock_.has_value();
  if (a.moves && a.final_frame < a.initial_frame)
    fail("Final_Frame is " + std::to_string(a.final_frame) + ", before Initial_Frame " +
         std::to_string(a.initial_frame));
  // As in POV-Ray, one frame that is not cyclic is a still.
  if (a.final_frame == a.initial_frame) a.moves = false;
  a.first = a.initial_frame;
  a.last = a.moves ? a.final_frame : a.initial_frame;
  if (!a.moves) return;
  if (!subset_start_.empty()) a.first = frame_or_part(subset_start_);
  if (!subset_end_.empty()) a.last = frame_or_part(subset_end_);
  if (a.last < a.first) fail("the subset ends before it starts");
}

PovIni IniReader::read() {
  const std::string text = read_text(path_);
  LineReader lines(text);
  while (lines.next()) {
    line_ = lines.number();
    std::string_view line = lines.line();
    if (const size_t comment = line.find(';'); comment != std::string_view::npos)
      line = trimmed(line.substr(0, comment));
    if (line.empty()) continue;
    if (line.front() == '[') break;  // settings for those who name the section
    const size_t equals = line.find('=');
    if (line.front() == '+' || line.front() == '-') {
      for (std::string_view rest = line; !trimmed(rest).empty();) command_line_switch(next_word(&rest));
    } else if (equals != std::string_view::npos && equals > 0) {
      setting(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
    } else {
      fail("found " + in_quotes(line) + ", expected NAME=VALUE");
    }
  }
  finish();
  if (ignored_line_ > 0)
    report_->add("settings of how pictures are drawn and stored are ignored", file_, ignored_line_);
  return std::move(ini_);
}

}  // namespace

PovIni read_pov_ini(const std::string& path, const SkipOptions& options, ImportReport* report) {
  return IniReader(path, options, report).read();
}

}  // namespace strad
