#!/bin/bash
# All frames of an animation by strad and by POV-Ray's radiosity, which solves each frame anew: CPU seconds, the error of
# the truth's frames and the flicker of four frames in the middle, in percent.
#
#   STRAD_TRUTH=DIR                      as for bench.sh; without it there is nothing to compare to
#   STRAD_BENCH_RIVALS='room4'           which scenes
#   STRAD_BENCH_RADIOSITY='count 200 error_bound 0.4 recursion_limit 8'    POV-Ray's settings: here the strongest
#                                        within some ten seconds a frame of room4
#
# POV-Ray gets the geometry and spotlights that strad-frame --pov writes for it, without baked light, so the two differ in
# nothing else. A lamp of emitting polygons is an area light to it, and itself black.
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/measure.bash"
radiosity=${STRAD_BENCH_RADIOSITY:-count 200 error_bound 0.4 recursion_limit 8}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

if ! [ -d "${STRAD_TRUTH:-/nonexistent}" ] || ! command -v povray >/dev/null; then
  echo "# no comparison to POV-Ray: STRAD_TRUTH names no folder, or there is no povray"
  exit 0
fi

# The frames of a list such as 61,150,298:301, one per line.
each() { tr , '\n' <<<"$1" | awk -F: '{ for (k = $1; k <= $NF; ++k) print k }' | sort -nu; }

flicker() { strad-diff "$1" "$1" -f "$2" --flicker 1e9 | value flicker_b | awk '{ printf "%.2f\n", 100 * $1 }'; }

# A coarse solution has all that is needed: which surfaces there are. Their light goes.
export_scene() {
  local frame
  strad-solve -q -e 50 "$work/scene.strad" >"$work/coarse.strad"
  for frame in $(each "$1"); do
    strad-frame -q -s "$size" -f "$frame" --pov -o "$work/a.%04d.inc" "$work/coarse.strad"
  done
  awk -f "$here/povray_geometry.awk" "$work/a_geometry.inc" >"$work/geometry.inc"
  for frame in $(each "$1"); do
    { echo "#declare strad_file = \"$(printf '%04d' "$frame").inc\";"; scene_file; } >"$work/a.$frame.pov"
    sed -e 's/"a_geometry.inc"/"geometry.inc"/' -e '/^#declare strad_radiance/,$d' "$work/$(printf 'a.%04d.inc' "$frame")" \
      >"$work/$(printf '%04d.inc' "$frame")"
  done
}
scene_file() {
  sed -e "s/assumed_gamma 1/& radiosity { $radiosity gray_threshold 0 }/" -e '/^#declare strad_frame/d' \
    -e 's/^#include concat.*/#include strad_file/' "$work/a.pov"
}

# povray_frames FRAMES: prints the mean CPU seconds of one.
povray_frames() {
  local frame
  for frame in $(each "$1"); do
    cpu /dev/null povray "+I$work/a.$frame.pov" "+L$work" "+O$work/$(printf 'povray_%04d.exr' "$frame")" \
      "+W${size%x*}" "+H${size#*x}" +FE +A0.1 +AM2 +R4 -J -D +WT1
  done | mean
}

row() { printf '%-9s %10s %12s %9s %9s\n' "$1" "$2" "$(awk -v a="$2" -v n="$3" -v b="${6:-0}" 'BEGIN { printf "%.0f", a * n + b }')" "$4" "$5"; }

for scene in ${STRAD_BENCH_RIVALS:-room4}; do
  rm -rf "$work"/*
  source_of "$scene" >"$work/scene.strad"
  frames=$(truth_frames "$scene")
  size=$(truth_size "$scene")
  count=$(fact frames)
  middle=$((count / 2)):$((count / 2 + 3))
  echo "# $scene, $count frames of $size: CPU s of a frame and of all (strad: with its solve), error and flicker in percent"
  printf '%-9s %10s %12s %9s %9s\n' by frame_s all_s rel flicker
  solve=$(cpu "$work/solved.strad" strad-solve -q "$work/scene.strad")
  frame=$(render "$work/strad_%04d.pfm" "$size" "$(each "$frames,$middle" | paste -sd, -)" "$work/solved.strad" -j 1)
  row strad "$frame" "$count" "$(rel "$scene" "$work/strad_%04d.pfm" "$frames")" "$(flicker "$work/strad_%04d.pfm" "$middle")" "$solve"
  export_scene "$frames,$middle"
  frame=$(povray_frames "$frames,$middle")
  row povray "$frame" "$count" "$(rel "$scene" "$work/povray_%04d.exr" "$frames")" "$(flicker "$work/povray_%04d.exr" "$middle")"
done
