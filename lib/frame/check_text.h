// A check's report as text and as JSON.
#pragma once

#include <string>

#include "frame/check_report.h"

namespace strad {

// Errors in percent, a line a group; the worst places as lines that parse_probes reads, all else of them
// behind #.
std::string check_text(const CheckReport& report);
// Errors as fractions.
std::string check_json(const CheckReport& report);

}  // namespace strad
