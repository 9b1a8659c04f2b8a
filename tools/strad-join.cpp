// strad-join: solutions of one scene over adjacent slabs of time, made one.
#include "solution/join.h"
#include "tool.h"

namespace strad {
namespace {

struct JoinOptions {
  Common common;
  std::vector<std::string> streams;
  std::string provenance;
};

JoinOptions parse_options(int argc, char** argv) {
  JoinOptions join;
  Options options("strad-join", "Join solutions of one scene over adjacent slabs of time.", &join.common);
  options.output();
  options.files("STREAM", &join.streams, "the streams, in any order", true);
  options.parse(argc, argv);
  join.provenance = options.provenance();
  return join;
}

int run(const JoinOptions& options) {
  refuse_terminal(options.common.output);
  Output output(options.common.output);
  StreamWriter writer([&output](ByteSpan bytes) { output.write(bytes); });
  join(options.streams, options.provenance, writer);
  output.commit();
  detail(options.common, "joined " + std::to_string(options.streams.size()) + " streams");
  return 0;
}

}  // namespace
}  // namespace strad

int main(int argc, char** argv) {
  return strad::run_tool("strad-join", [&] { return strad::run(strad::parse_options(argc, argv)); });
}
