#include "export/ply/write_ply.h"

#include "base/error.h"
#include "export/ply/ply.h"
#include "stream/output_file.h"

namespace strad {

void write_ply(const FrameRequest& request, const Progress& progress) {
  const Stream stream = read_solved(request.stream);
  const std::vector<FrameTime> frames =
      requested_frames(request, stream.scene, solved_range(*stream.solution));
  if (!goes_to_files(request) && frames.size() > 1) {
    throw BadInput("--ply: found " + std::to_string(frames.size()) +
                   " frames for standard output, expected one, or -o with a pattern such as frame.%04d.ply");
  }
  const PlyExport meshes(stream.scene, *stream.solution);
  if (!goes_to_files(request)) {
    report_frame(progress, 0, 1, frames.front().number);
    return write_text_file("-", meshes.frame(frames.front().time, request.exposure));
  }
  const FilePattern pattern = output_pattern(request, frames.size());
  for (size_t i = 0; i < frames.size(); ++i) {
    report_frame(progress, i, frames.size(), frames[i].number);
    write_text_file(pattern.name(frames[i].number), meshes.frame(frames[i].time, request.exposure));
  }
}

}  // namespace strad
