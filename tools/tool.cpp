// What all tools share.
#include "tool.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>

namespace strad {
namespace {

std::string tool_name = "strad";  // set by run_tool, for notes

// One line, whatever the text holds.
void print_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  std::cerr << tool_name << ": " << text << std::endl;
}

int trouble(const std::string& text) {
  print_line(text);
  return kTrouble;
}

// A text that did not reach standard output is trouble, too.
int flushed(int status) {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout))
    return trouble("standard output: cannot be written");
  return status;
}

}  // namespace

int run_tool(const std::string& name, const std::function<int()>& body) {
  tool_name = name;
  std::signal(SIGPIPE, SIG_DFL);  // a closed pipe ends the tool, as it ends cat
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond its limit is an error of the write
  try {
    return flushed(body());
  } catch (const Finished&) {
    return flushed(0);
  } catch (const std::bad_alloc&) {
    return trouble("out of memory");
  } catch (const std::exception& error) {
    return trouble(error.what());
  }
}

void note(const Common& common, const std::string& text) {
  if (!common.quiet) print_line(text);
}

void detail(const Common& common, const std::string& text) {
  if (common.verbose) note(common, text);
}

std::string stream_summary(const std::string& name, const Stream& stream) {
  const Scene& s = stream.scene;
  std::string text = name.empty() || name == "-" ? "standard input" : name;
  const auto add = [&](const char* between, size_t count, const char* what) {
    text += between + std::to_string(count) + " " + what;
  };
  add(": ", s.polygons.size(), "polygons"), add(", ", s.objects.size(), "objects");
  add(", ", s.materials.size(), "materials"), add(", ", s.textures.size(), "textures");
  add(", ", s.bodies.size() - 1, "bodies"), add(", ", s.spots.size(), "spots");
  add(", ", s.glows.size(), "glows"), add(", ", s.cameras.size(), "cameras");
  add(", ", static_cast<size_t>(frame_count(s)), "frames");
  if (stream.solution) add(", ", stream.solution->slabs.size(), "solved slabs");
  return text;
}

void refuse_terminal(const std::string& output) {
  if ((output.empty() || output == "-") && ::isatty(STDOUT_FILENO) == 1)
    throw BadInput("standard output is a terminal, expected a pipe, a file or -o FILE");
}

void write_stream(Stream stream, const std::string& provenance, const Common& common) {
  refuse_terminal(common.output);
  if (!provenance.empty()) stream.scene.provenance.push_back(provenance);
  Output output(common.output);
  StreamWriter writer([&output](ByteSpan bytes) { output.write(bytes); });
  write_stream(stream, writer);
  output.commit();
}

}  // namespace strad
