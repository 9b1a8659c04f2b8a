// What a solve did and cost, as JSON.
#pragma once

#include <string>

#include "solve/stats.h"

namespace strad {

std::string stats_as_json(const SolveStats& stats);

}  // namespace strad
