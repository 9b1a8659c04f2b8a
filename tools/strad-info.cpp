// strad-info: what is in a stream, as text or JSON.
#include <iostream>

#include "solution/facts.h"
#include "tool.h"

namespace strad {
namespace {

struct InfoOptions {
  Common common;
  std::string stream;
  bool json = false;
  FactChoice choice;
};

InfoOptions parse_options(int argc, char** argv) {
  InfoOptions info;
  Options options("strad-info", "Tell what is in a strad stream.", &info.common);
  options.flag("--json", &info.json, "print JSON");
  options.flag("--chunks", &info.choice.chunks, "list each chunk with its offset");
  options.flag("--objects", &info.choice.objects,
               "list objects, materials and bodies with their sizes and places at rest");
  options.output();
  options.file("STREAM", &info.stream, "the stream; standard input when absent or -");
  options.parse(argc, argv);
  return info;
}

int tell(const InfoOptions& info) {
  StreamReader reader(info.stream);
  std::vector<ChunkFacts> chunks;
  const Stream stream = read_with_chunks(reader, &chunks);
  detail(info.common, stream_summary(info.stream, stream));
  const Fact facts = describe(stream, chunks, info.choice);
  Output output(info.common.output);
  output.write(info.json ? to_json(facts) : to_text(facts));
  output.commit();
  return 0;
}

}  // namespace
}  // namespace strad

int main(int argc, char** argv) {
  return strad::run_tool("strad-info", [&] { return strad::tell(strad::parse_options(argc, argv)); });
}
