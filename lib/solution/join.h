// Solutions of one scene over adjacent slabs of time, made one.
#pragma once

#include <string>
#include <vector>

#include "stream/writer.h"

namespace strad {

// Copies scene and slabs of the streams at `paths` ("-": standard input), the slabs in order of time and
// unchanged to the byte. `provenance` is added after the lines of all. Throws BadInput when scenes differ, or
// time has a gap or an overlap.
void join(const std::vector<std::string>& paths, const std::string& provenance, StreamWriter& writer);

}  // namespace strad
