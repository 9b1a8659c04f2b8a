#include "frame/frame_list.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "base/number_list.h"

namespace strad {
namespace {

constexpr int kMaxSide = 16384;  // pixels; 2^28 in all, more than any display or printer asks for

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t begin = 0;;) {
    const size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

// `text` as a number, or nothing if any of it is something else.
template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string in_words(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", seconds);
  return text;
}

[[noreturn]] void refuse(const std::string& option, std::string_view found, const std::string& expected) {
  throw BadInput(option + ": found '" + std::string(found) + "', expected " + expected);
}

// Times are refused only where they lie outside by more than rounding: a frame's time is a quotient.
bool holds(TimeRange range, double time) {
  const double slack = 1e-9 * (1 + std::abs(range.begin) + std::abs(range.end));
  return time >= range.begin - slack && time <= range.end + slack;
}

std::string range_words(TimeRange range) {
  return std::string(range.of) + " holds " + in_words(range.begin) + " to " + in_words(range.end) + " s";
}

}  // namespace

TimeRange solved_range(const Solution& solution) {
  return {slab_begin(solution.slabs.front()), slab_end(solution.slabs.back()), "the solution"};
}

std::vector<FrameTime> parse_frames(const Scene& scene, TimeRange range, const std::string& option,
                                    const std::string& text) {
  const int count = frame_count(scene);
  const NumberBounds bounds{1, count, "frames 1 to " + std::to_string(count)};
  std::vector<FrameTime> frames;
  for (const int k : parse_number_list(option, text, bounds)) {
    const double time = frame_time(scene, k);
    if (!holds(range, time)) {
      throw BadInput(option + ": frame " + std::to_string(k) + " is at " + in_words(time) + " s, but " +
                     range_words(range));
    }
    frames.push_back({k, time});
  }
  return frames;
}

std::vector<FrameTime> parse_times(TimeRange range, const std::string& option, const std::string& text) {
  std::vector<FrameTime> times;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> time = number_in<double>(part);
    if (!time || !std::isfinite(*time)) refuse(option, text, "times in seconds, T,T,...");
    if (!holds(range, *time)) {
      throw BadInput(option + ": found " + std::string(part) + " s, but " + range_words(range));
    }
    times.push_back({static_cast<int>(times.size()) + 1, *time});
  }
  return times;
}

std::vector<FrameTime> all_frames(const Scene& scene, TimeRange range) {
  std::vector<FrameTime> frames;
  for (int k = 1; k <= frame_count(scene); ++k) {
    if (holds(range, frame_time(scene, k))) frames.push_back({k, frame_time(scene, k)});
  }
  if (frames.empty()) frames.push_back({1, range.begin});
  return frames;
}

PictureSize parse_size(const std::string& option, const std::string& text) {
  const std::string expected = "WxH, each 1 to " + std::to_string(kMaxSide);
  const std::vector<std::string_view> parts = split(text, 'x');
  if (parts.size() != 2) refuse(option, text, expected);
  const std::optional<int> width = number_in<int>(parts[0]), height = number_in<int>(parts[1]);
  const bool sound =
      width && height && *width >= 1 && *height >= 1 && *width <= kMaxSide && *height <= kMaxSide;
  if (!sound) refuse(option, text, expected);
  return {static_cast<uint32_t>(*width), static_cast<uint32_t>(*height)};
}

}  // namespace strad
