#!/bin/bash
# How cost grows with the scene: halls of more and more polygons (scenes/halls) at one -e. Seconds of CPU, of wall for
# the solve alone; what was counted; and CPU seconds and links over those of the row before, divided by n log n over its
# n log n: not above 1 when growth is no worse than n log n.
#
#   STRAD_BENCH_SCALE='1000 10000 100000 1000000'    how many polygons (1000 10000), STRAD_BENCH_SCALE_ERROR=0.1: -e
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/measure.bash"
error=${STRAD_BENCH_SCALE_ERROR:-0.1}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

row() {
  local halls=$work/halls import motion info solve total
  "$here/../../scenes/halls/halls.sh" "$1" "$halls"
  import=$(cpu "$work/imported.strad" strad-import -q "$halls/halls.obj")
  motion=$(cpu "$work/scene.strad" strad-motion -q "$halls/halls.motion" "$work/imported.strad")
  info=$(cpu /dev/null strad-info "$work/scene.strad")
  solve=$(cpu "$work/solved.strad" strad-solve -q -e "$error" --stats "$work/stats" "$work/scene.strad")
  echo "$1 $import $motion $info $solve $(total wall_seconds) $(total links) $(total links_refined_in_time)" \
    "$(total links_refined_in_space) $(stat_of "$work/stats" all clusters) $(total rays)" \
    "$(stat_of "$work/stats" bytes peak) $(stat -c %s "$work/solved.strad")"
}
total() { stat_of "$work/stats" total "$1"; }

echo "# halls, -e $error: CPU s (wall_s: of the solve), counts, growth over n log n"
printf '%9s %9s %9s %9s %9s %9s %11s %11s %11s %9s %13s %12s %11s %7s %7s\n' polygons import_s motion_s info_s solve_s wall_s \
  links in_time in_space clusters rays peak_bytes file_bytes s/nlogn l/nlogn
for polygons in ${STRAD_BENCH_SCALE:-1000 10000}; do
  row "$polygons"
done | awk '
  function growth(now, before) { return before > 0 ? sprintf("%.2f", now / before / (work_of / work_before)) : "-" }
  {
    work_of = $1 * log($1)
    printf "%9s %9s %9s %9s %9s %9s %11s %11s %11s %9s %13s %12s %11s %7s %7s\n", $1, $2, $3, $4, $5, $6, $7, $8, $9, $10, $11, $12,
      $13, growth($5, seconds), growth($7, links)
    fflush()
    work_before = work_of; seconds = $5; links = $7
  }'
