// Solutions of one scene over adjacent slabs of time, made one.
#pragma once

#include <string>
#include <vector>

#include "stream/writer.h"

namespace strad {

// Copies the scene and all slabs of the streams at `paths` ("-": standard input). The slabs are ordered by
// time, and their bytes do not change. `provenance` is added after the provenance lines of all streams.
// Throws BadInput when the scenes differ, or when there is a gap or an overlap in time.
void join(const std::vector<std::string>& paths, const std::string& provenance, StreamWriter& writer);

}  // namespace strad
