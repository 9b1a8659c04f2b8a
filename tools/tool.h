// What all tools share: exit statuses, streams in and out, notes.
#pragma once

#include <functional>
#include <string>

#include "base/error.h"
#include "solution/solution_file.h"
#include "solution/stream_io.h"
#include "stream/output_file.h"
#include "tool_options.h"

namespace strad {

constexpr int kTrouble = 2;

// Runs `body` and returns its exit status. An exception becomes one line "NAME: text" on standard error and
// status 2; a closed pipe ends the tool quietly.
//
//   int main(int argc, char** argv) {
//     return strad::run_tool("strad-probe", [&] { return probe(parse_options(argc, argv)); });
//   }
int run_tool(const std::string& name, const std::function<int()>& body);

// One line "NAME: note" on standard error unless `common.quiet`. REQUIRES: inside run_tool.
void note(const Common& common, const std::string& text);

// The same for -v only.
void detail(const Common& common, const std::string& text);

// What a stream holds, for detail(): "NAME: 12 polygons, ...".
std::string stream_summary(const std::string& name, const Stream& stream);

// Reading is read_stream(path) of solution/stream_io.h. Writing appends `provenance` to the stream's, unless
// it is empty, then writes to common.output; throws BadInput rather than writing to a terminal.
void write_stream(Stream stream, const std::string& provenance, const Common& common);

// Throws BadInput when standard output is a terminal and `output` names it: for tools with binary output.
void refuse_terminal(const std::string& output);

}  // namespace strad
