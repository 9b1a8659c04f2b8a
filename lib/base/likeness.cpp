#include "base/likeness.h"

#include <algorithm>

namespace strad {
namespace {
// How many letters must be changed, put in, left out or exchanged with their neighbours to make `a` of `b`
// (Damerau 1964).
size_t distance_of(std::string_view a, std::string_view b) {
  std::vector<std::vector<size_t>> cost(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i)
    for (size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      cost[i][j] =
          std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  return cost[a.size()][b.size()];
}
}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  constexpr size_t kLongest = 64;  // of words that anybody means
  std::string best;
  size_t least = std::max<size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : known) {
    if (std::max(candidate.size(), word.size()) > kLongest) continue;
    const size_t distance = distance_of(word, candidate);
    if (distance < least) least = distance, best = candidate;
  }
  return best.empty() ? "" : ", did you mean " + best + "?";
}

}  // namespace strad
