// What all tools share.
#include "tool.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <mutex>
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

void refuse_terminal(const std::string& output) {
  if ((output.empty() || output == "-") && ::isatty(STDOUT_FILENO) == 1)
    throw BadInput("standard output is a terminal, expected a pipe, a file or -o FILE");
}

void write_stream(Stream stream, const std::string& provenance, const Common& common) {
  refuse_terminal(common.output);
  stream.scene.provenance.push_back(provenance);
  Output output(common.output);
  StreamWriter writer([&output](ByteSpan bytes) { output.write(bytes); });
  write_stream(stream, writer);
  output.commit();
}

namespace {

using Clock = std::chrono::steady_clock;

// Drawn after a second and then ten times a second; wiped at the end.
class Bar {
 public:
  ~Bar() {
    if (drawn_) std::fputs("\r\33[K", stderr);
  }

  void draw(double fraction, const std::string& what) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    drawn_ = true;
    constexpr int kWidth = 40;
    const int filled = static_cast<int>(kWidth * std::min(std::max(fraction, 0.0), 1.0));
    const std::string bar = std::string(static_cast<size_t>(filled), '#') +
                            std::string(static_cast<size_t>(kWidth - filled), '.');
    std::fprintf(stderr, "\r\33[K[%s] %3d %% %s", bar.c_str(), static_cast<int>(100 * fraction),
                 what.c_str());
    std::fflush(stderr);
  }

 private:
  std::mutex mutex_;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
  bool drawn_ = false;
};

}  // namespace

std::function<void(double, const std::string&)> progress_bar(const Common& common) {
  if (common.quiet || ::isatty(STDERR_FILENO) != 1) return [](double, const std::string&) {};
  return [bar = std::make_shared<Bar>()](double fraction, const std::string& what) {
    bar->draw(fraction, what);
  };
}

}  // namespace strad
