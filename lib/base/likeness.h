// Words that are like each other, for "did you mean".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace strad {

// ", did you mean X?" for the one of `known` that is most like `word`, if it is like it; else "".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace strad
