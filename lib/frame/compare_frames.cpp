#include "frame/compare_frames.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "base/error.h"
#include "frame/frames_on_disk.h"
#include "image/files.h"

namespace strad {
namespace {

// White in a heat map, as a fraction of the reference's mean.
constexpr double kFullHeat = 0.5;

struct FrameSet {
  int number = 0;
  Image a, b, twin;
  std::vector<bool> left_out;
};

// What the flicker of a sequence is summed up from.
struct FlickerSums {
  int triples = 0;
  double a = 0, b = 0, excess = 0;
};

FilePattern pattern_of(const std::string& path) { return FilePattern("file name", path); }

bool is_pattern(const std::string& path) { return pattern_of(path).numbered(); }

std::string file_of(const std::string& path, std::optional<int> number) {
  return number ? pattern_of(path).name(*number) : path;
}

Image load_checked(const std::string& path) {
  Image image = load_image(path);
  require_finite(image, path);
  return image;
}

std::vector<bool> load_labels(const std::string& path, int bits, const Image& image) {
  const SrgbImage labels = load_srgb_image(path);
  if (labels.width != image.width || labels.height != image.height)
    throw BadInput(path + ": found labels of another size than the pictures");
  std::vector<bool> left_out(image.pixels.size());
  for (size_t pixel = 0; pixel < left_out.size(); ++pixel)
    left_out[pixel] = (labels.bytes[3 * pixel] & bits) != 0;
  return left_out;
}

FrameSet load_frame(const FrameFiles& files, std::optional<int> number) {
  const std::string path_a = file_of(files.a, number), path_b = file_of(files.b, number);
  FrameSet frame;
  frame.number = number.value_or(0);
  frame.a = load_checked(path_a);
  frame.b = load_checked(path_b);
  require_equal_sizes(frame.a, path_a, frame.b, path_b);
  if (!files.twin.empty()) {
    const std::string path = file_of(files.twin, number);
    frame.twin = load_checked(path);
    require_equal_sizes(frame.a, path_a, frame.twin, path);
  }
  if (!files.labels.empty())
    frame.left_out = load_labels(file_of(files.labels, number), files.label_bits, frame.a);
  return frame;
}

// The numbers that both patterns have on disk. Throws unless they are the same.
std::vector<int> paired_frames(const FrameFiles& files) {
  const FilePattern pattern_a = pattern_of(files.a), pattern_b = pattern_of(files.b);
  const std::vector<int> a = frames_on_disk(pattern_a), b = frames_on_disk(pattern_b);
  if (a.empty()) throw IoError(files.a + ": found no file of this name, expected a sequence");
  std::vector<int> alone;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(alone));
  if (alone.empty()) return a;
  const bool in_a = std::binary_search(a.begin(), a.end(), alone.front());
  throw IoError((in_a ? pattern_b : pattern_a).name(alone.front()) +
                ": no such file, expected since there is " +
                (in_a ? pattern_a : pattern_b).name(alone.front()));
}

std::vector<bool> either(std::vector<bool> a, const std::vector<bool>& b) {
  for (size_t i = 0; i < a.size(); ++i) a[i] = a[i] || b[i];
  return a;
}

void add_flicker(const FrameSet (&last)[3], FlickerSums* sums) {
  if (last[0].number + 1 != last[1].number || last[1].number + 1 != last[2].number) return;
  const std::vector<bool> left_out = either(either(last[0].left_out, last[1].left_out), last[2].left_out);
  const Flicker a = flicker(last[0].a, last[1].a, last[2].a, left_out);
  const Flicker b = flicker(last[0].b, last[1].b, last[2].b, left_out);
  const Flicker excess = flicker(difference(last[0].a, last[0].b), difference(last[1].a, last[1].b),
                                 difference(last[2].a, last[2].b), left_out);
  if (!(a.mean > 0 && b.mean > 0)) return;
  sums->a += a.rms / a.mean;
  sums->b += b.rms / b.mean;
  sums->excess += excess.rms / a.mean;
  ++sums->triples;
}

void require_all_patterns(const FrameFiles& files) {
  for (const std::string* path : {&files.b, &files.twin, &files.labels, &files.heat_map})
    if (!path->empty() && is_pattern(*path) != is_pattern(files.a))
      throw BadInput(*path + ": expected " + (is_pattern(files.a) ? "a pattern" : "one file") + ", as is " +
                     files.a);
  if (!files.frames.empty() && !is_pattern(files.a))
    throw BadInput(files.a + ": found one file, expected a pattern such as a.%04d.exr to choose frames of");
}

std::vector<std::optional<int>> numbers_of(const FrameFiles& files) {
  if (!is_pattern(files.a)) return {std::nullopt};
  const std::vector<int> numbers = files.frames.empty() ? paired_frames(files) : files.frames;
  return {numbers.begin(), numbers.end()};
}

}  // namespace

FramesComparison compare_frames(const FrameFiles& files, const SeePicture& see) {
  require_all_patterns(files);
  if (!files.heat_map.empty()) require_image_format(files.heat_map);
  FramesComparison result;
  std::vector<Comparison> frames;
  double largest = -1;
  FrameSet last[3];
  FlickerSums sums;
  for (const std::optional<int> number : numbers_of(files)) {
    std::rotate(last, last + 1, last + 3);
    FrameSet& frame = last[2] = load_frame(files, number);
    frames.push_back(compare(frame.a, frame.b, files.twin.empty() ? nullptr : &frame.twin, frame.left_out));
    if (see) see(file_of(files.b, number), frames.back());
    if (frames.back().largest > largest) {
      largest = frames.back().largest;
      result.worst_file = file_of(files.b, number);
    }
    if (frames.size() >= 3) add_flicker(last, &sums);
    if (!files.heat_map.empty())
      save_image(file_of(files.heat_map, number),
                 heat_map(frame.a, frame.b, kFullHeat * frames.back().mean_a));
  }
  result.frames = static_cast<int>(frames.size());
  result.total = mean_of(frames);
  if (sums.triples == 0) return result;
  result.flicker_a = sums.a / sums.triples;
  result.flicker_b = sums.b / sums.triples;
  result.flicker_excess = sums.excess / sums.triples;
  return result;
}

}  // namespace strad
