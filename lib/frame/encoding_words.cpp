#include "frame/encoding_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "image/files.h"

namespace strad {
namespace {

constexpr std::pair<const char*, Depth> kDepths[] = {
    {"half", Depth::kHalf}, {"float", Depth::kFloat}, {"8", Depth::kByte}, {"16", Depth::kWord}};

ToneCurve tone_of(const std::string& word) {
  if (word == "linear") return ToneCurve::kLinear;
  return word == "filmic" ? ToneCurve::kFilmic : ToneCurve::kSrgb;
}

Depth depth_of(const std::string& word, const std::string& path) {
  std::string expected;
  const std::vector<Depth> known = depths_of(format_of(path));
  for (const auto& [name, depth] : kDepths) {
    if (std::find(known.begin(), known.end(), depth) == known.end()) continue;
    if (name == word) return depth;
    expected += (expected.empty() ? "" : " or ") + std::string(name);
  }
  if (word.empty()) return known.front();
  throw BadInput("--depth: found '" + word + "', expected " + expected + " for " + format_of(path));
}

}  // namespace

Encoding parse_encoding(const EncodingWords& words, const std::string& path) {
  if (words.white && !(*words.white > 0 && std::isfinite(*words.white)))
    throw BadInput("--white: expected a radiance above 0");
  Encoding encoding;
  encoding.tone = tone_of(words.tone);
  encoding.white = words.white ? static_cast<float>(*words.white) : usual_white(encoding.tone);
  encoding.depth = depth_of(words.depth, path);
  if (is_float(encoding.depth) && (!words.tone.empty() || words.white))
    throw BadInput(std::string(words.tone.empty() ? "--white" : "--tone") + ": found pictures of floats (" +
                   format_of(path) + "), which keep light as it is, expected whole numbers");
  return encoding;
}

}  // namespace strad
