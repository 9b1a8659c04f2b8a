#include "targets.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "base/error.h"
#include "frame/probe_text.h"
#include "image/pnm.h"
#include "import/gltf/gltf.h"
#include "import/obj/mtl.h"
#include "import/obj/obj.h"
#include "import/pov/ini.h"
#include "import/pov/pov.h"
#include "scene/motion_io.h"
#include "scene/motion_print.h"
#include "scene/motion_text.h"
#include "scene/scene_io.h"
#include "solution/bucket_io.h"
#include "solution/join.h"
#include "solution/slab_work.h"
#include "solution/solution_file.h"
#include "solution/solution_io.h"

namespace strad {
namespace {

using Input = std::span<const uint8_t>;

std::string text_of(Input input) { return {input.begin(), input.end()}; }

// A file in memory with these bytes, for readers that take a path.
class InputFile {
 public:
  explicit InputFile(Input input) : descriptor_(::memfd_create("input", MFD_CLOEXEC)) {
    if (descriptor_ < 0 ||
        ::write(descriptor_, input.data(), input.size()) != static_cast<ssize_t>(input.size()))
      std::abort();
  }
  ~InputFile() { ::close(descriptor_); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

// What is refused is refused with one of the two errors; anything else is a find.
template <class Body>
void accepted_or_refused(Body body) {
  try {
    body();
  } catch (const BadInput&) {
  } catch (const IoError&) {
  }
}

// Whatever is missing or unknown is left out, so that the rest is reached; then strictly.
template <class Import>
void import_both_ways(Import import) {
  for (const bool skip : {true, false}) {
    accepted_or_refused([&] {
      ImportOptions options;
      options.skip_missing = options.skip_unknown = skip;
      ImportReport report;
      encode_scene(import(options, &report));
      report.lines();
    });
  }
}

void obj(Input input) {
  const InputFile file(input);
  import_both_ways([&](const ImportOptions& options, ImportReport* report) {
    return import_obj(file.path(), options, report);
  });
}

void mtl(Input input) {
  const InputFile file(input);
  accepted_or_refused([&] { read_mtl(file.path()); });
}

// A still, or the two frames of an animation where the first byte is a blank. Loops are short, for speed.
void pov(Input input) {
  const InputFile file(input);
  PovAnimation animation;
  animation.run.most_steps = 1000;
  animation.run.most_words = 20'000;
  if (!input.empty() && input[0] == ' ') {
    animation.moves = true;
    animation.final_frame = animation.last = 2;
  }
  import_both_ways([&](ImportOptions options, ImportReport* report) {
    options.tessellate = 4;
    return import_pov(file.path(), options, report, animation);
  });
}

void ini(Input input) {
  const InputFile file(input);
  accepted_or_refused([&] {
    ImportReport report;
    const PovIni read = read_pov_ini(file.path(), {}, &report);
    run_of(read.animation, read.animation.first);
    run_of(read.animation, read.animation.last);
  });
}

void gltf(Input input) {
  const InputFile file(input);
  import_both_ways([&](const ImportOptions& options, ImportReport* report) {
    return import_gltf(file.path(), options, {}, report);
  });
}

Scene small_scene() {
  Scene scene;
  scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.materials.resize(1);
  scene.materials[0].name = "lamp";
  scene.objects = {{"cart", 0}, {"wheel", 0}};
  scene.polygons.resize(2);
  for (uint32_t i = 0; i < 2; ++i) {
    for (uint32_t c = 0; c < 3; ++c) scene.polygons[i].corners[c] = c;
    scene.polygons[i].material = 0;
    scene.polygons[i].object = i;
  }
  return scene;
}

// Motion that is accepted can be printed, and what is printed changes nothing.
void motion(Input input) {
  accepted_or_refused([&] {
    Scene scene = small_scene();
    apply_motion(text_of(input), "motion", scene);
    Bytes before, after;
    put_motion(&before, scene);
    std::string printed;
    try {
      printed = print_motion(scene);
    } catch (const BadInput&) {
      return;  // a name that cannot be written
    }
    apply_motion(printed, "printed", scene);
    put_motion(&after, scene);
    if (before != after) std::abort();
  });
}

void probes(Input input) {
  accepted_or_refused([&] { parse_probes("points", text_of(input)); });
  accepted_or_refused([&] { parse_probe("--at", text_of(input)); });
}

void pnm(Input input) {
  accepted_or_refused([&] { decode_pnm(text_of(input), "picture"); });
}

// Gives each chunk of a stream the checksum that fits, so that what is behind is reached.
Bytes with_checksums(Input input) {
  Bytes stream(input.begin(), input.end());
  if (stream.size() >= kPreludeSize) {
    std::copy(std::begin(kMagic), std::end(kMagic), stream.begin());
    std::memcpy(stream.data() + sizeof kMagic, "\1\0\0\0", 4);
  }
  for (size_t at = kPreludeSize; at + kChunkHeaderSize + kChecksumSize <= stream.size();) {
    const uint64_t length = get_u64(stream, at + 4);
    if (length > stream.size() - at - kChunkHeaderSize - kChecksumSize) break;
    Bytes sum;
    put_u64(&sum, checksum(ByteSpan(stream).subspan(at, kChunkHeaderSize + length)));
    at += kChunkHeaderSize + length;
    std::copy(sum.begin(), sum.end(), stream.begin() + static_cast<ptrdiff_t>(at));
    at += kChecksumSize;
  }
  return stream;
}

void look_at(SolutionFile file) {
  for (const double part : {0.0, 0.3, 1.0}) {
    const double time = file.begin() + part * (file.end() - file.begin());
    light_at(file.slab_at(time), time);
  }
}

// The framing: read in order, and from the index.
void stream(Input input) {
  const Bytes bytes = with_checksums(input);
  accepted_or_refused([&] {
    StreamReader reader(bytes, "stream");
    read_stream(reader);
  });
  const InputFile file(bytes);
  accepted_or_refused([&] { look_at(SolutionFile(file.path())); });
}

void join_parts(Input input) {
  const InputFile file(with_checksums(input));
  accepted_or_refused([&] {
    StreamWriter writer([](ByteSpan) {});
    join({file.path(), file.path()}, "fuzz", writer);
  });
  accepted_or_refused([&] {
    Bytes joined;
    StreamWriter writer([&](ByteSpan more) { joined.insert(joined.end(), more.begin(), more.end()); });
    join({file.path()}, "fuzz", writer);
    StreamReader reader(joined, "joined");  // must be readable
    try {
      read_stream(reader);
    } catch (const BadInput&) {
      std::abort();
    }
  });
}

// The decoders behind the compression. The input: for each chunk its type, 4 letters, a u32 length and its
// content.
void content(Input input) {
  SceneDecoder decoder;
  std::optional<Scene> scene;
  std::vector<Slab> slabs;
  std::vector<Bucket> direct, indirect;
  const auto finish_slab = [&] {
    if (slabs.empty()) return;
    slabs.back().direct = assemble_field(slabs.back(), direct, "direct");
    slabs.back().indirect = assemble_field(slabs.back(), indirect, "indirect");
    direct.clear(), indirect.clear();
  };
  accepted_or_refused([&] {
    while (input.size() >= 8) {
      ChunkType type;
      std::copy_n(input.begin(), 4, type.begin());
      const size_t length = std::min<size_t>(get_u32(input, 4), input.size() - 8);
      const Input bytes = input.subspan(8, length);
      input = input.subspan(8 + length);
      if (SceneDecoder::knows(type)) decoder.add(type, bytes, "scene");
      if (type == kWorkChunk) decode_work(bytes, "work");
      if (type == kIndexChunk) decode_index(bytes, "index");
      if (type == kSlabChunk) {
        if (!scene) scene = decoder.finish("scene");
        finish_slab();
        slabs.push_back(decode_slab(*scene, bytes, "slab"));
        slab_entry(0, slabs.back());
      }
      if (slabs.empty()) continue;
      if (type == kDirectChunk) direct.push_back(decode_bucket(slabs.back(), bytes, "bucket"));
      if (type == kIndirectChunk) indirect.push_back(decode_bucket(slabs.back(), bytes, "bucket"));
    }
    if (!scene) scene = decoder.finish("scene");
    finish_slab();
    const Solution solution{slabs};
    if (slabs.empty()) return;
    validate(*scene, solution);
    for (const Slab& slab : slabs) {
      light_at(slab, slab_begin(slab));
      light_over(slab, slab_begin(slab), slab_end(slab));
      encode_slab(*scene, slab);
    }
  });
}

}  // namespace

const std::vector<FuzzTarget>& fuzz_targets() {
  static const std::vector<FuzzTarget> targets{{"obj", obj},         {"mtl", mtl},        {"pov", pov},
                                               {"ini", ini},         {"gltf", gltf},      {"motion", motion},
                                               {"probes", probes},   {"pnm", pnm},        {"stream", stream},
                                               {"join", join_parts}, {"content", content}};
  return targets;
}

}  // namespace strad
