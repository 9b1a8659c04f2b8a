// What strad-probe reads and writes: points, and a table of tab-separated columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frame/probe.h"

namespace strad {

// "X,Y,Z" or "X,Y,Z,NX,NY,NZ". Throws BadInput beginning with `option`.
ProbeQuery parse_probe(const std::string& option, std::string_view text);

// One point per line, its numbers separated by blanks, tabs or commas; # begins a comment. Throws BadInput
// "NAME:LINE: ...".
std::vector<ProbeQuery> parse_probes(const std::string& name, std::string_view text);

// "time point object r g b er eg eb", ended by a newline.
std::string probe_header();
// `name` of the object: blanks, tabs, newlines and backslashes become \040, \011, \012 and \134.
std::string probe_row(double time, size_t point, const std::string& name, const ProbeValue& value);

}  // namespace strad
