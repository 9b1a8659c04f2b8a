#!/bin/bash
# CPU seconds of single frames, each by a process of its own and one thread, by size; of 4 x 4 pixels, which is the start;
# and of a frame among many by one process.
#
#   STRAD_BENCH_FRAMES='room4 cornell'    which scenes, STRAD_BENCH_SIZES='192x144 640x360 1920x1080': sizes
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/measure.bash"
sizes=${STRAD_BENCH_SIZES:-192x144 640x360 1920x1080}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

echo "# frames: CPU s by size; start alone; a frame of the first size among twenty"
printf '%-9s' scene
printf ' %10s' $sizes start of_twenty
echo
for scene in ${STRAD_BENCH_FRAMES:-room4 cornell}; do
  source_of "$scene" >"$work/scene.strad"
  strad-solve -q "$work/scene.strad" >"$work/solved.strad"
  count=$(fact frames)
  frames=$((count / 5)),$((count / 3)),$((count / 2))
  printf '%-9s' "$scene"
  for size in $sizes 4x4; do
    printf ' %10s' "$(render "$work/frame_%04d.png" "$size" "$frames" "$work/solved.strad" -j 1)"
  done
  twenty=$(cpu /dev/null strad-frame -q -j 1 -s "${sizes%% *}" -f $((count / 2 - 19)):$((count / 2)) -o "$work/frame_%04d.png" \
    "$work/solved.strad")
  printf ' %10s\n' "$(awk -v s="$twenty" 'BEGIN { printf "%.3f", s / 20 }')"
done
