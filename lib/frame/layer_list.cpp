#include "frame/layer_list.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "base/error.h"

namespace strad {
namespace {

constexpr std::string_view kWords[] = {"combined", "direct", "indirect", "emission",
                                       "specular", "albedo", "normal",   "position",
                                       "depth",    "motion", "object",   "material"};

}  // namespace

const char* word_of(LayerKind kind) { return kWords[static_cast<size_t>(kind)].data(); }

bool is_picture(LayerKind kind) { return kind <= LayerKind::kNormal; }

std::vector<LayerKind> parse_layers(const std::string& option, const std::string& text) {
  std::vector<LayerKind> kinds;
  if (text == "all") {
    for (size_t k = 0; k < std::size(kWords); ++k)
      if (static_cast<LayerKind>(k) != LayerKind::kSpecular) kinds.push_back(static_cast<LayerKind>(k));
    return kinds;
  }
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    const auto found = std::find(std::begin(kWords), std::end(kWords), word);
    if (found == std::end(kWords)) {
      std::string known = "all";
      for (const std::string_view one : kWords) known += ", " + std::string(one);
      throw BadInput(option + ": found '" + word + "', expected some of " + known);
    }
    const auto kind = static_cast<LayerKind>(found - std::begin(kWords));
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace strad
