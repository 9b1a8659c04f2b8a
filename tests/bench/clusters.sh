#!/bin/bash
# What clusters do: the same scenes solved at one -e with them and with links between surfaces only.
#
#   STRAD_BENCH_CLUSTERS='room4 halls-1000'    scenes, or GENERATOR-N, STRAD_BENCH_CLUSTERS_ERROR=0.1: -e
#   STRAD_BENCH_PICTURES=FOLDER                also heat maps of the jump at half time, as solved and as frames show it
#   STRAD_BENCH_FINER=4                        also the error of both against surfaces only at a fourth of that -e
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/measure.bash"
error=${STRAD_BENCH_CLUSTERS_ERROR:-0.1}
finer=${STRAD_BENCH_FINER:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

total() { stat_of "$work/$1.stats" total "$2"; }

# compare A B: the difference of two solutions in percent of the mean of A.
compare() { strad-diff "$work/$1.strad" "$work/$2.strad" --rel-rmse 1e9 | value rel_rmse | awk '{ printf "%.2f\n", 100 * $1 }'; }

row() {  # row NAME OPTIONS...
  local name=$1 solve
  shift
  solve=$(cpu "$work/$name.strad" strad-solve -q -e "$error" --stats "$work/$name.stats" "$@" "$work/scene.strad")
  printf '%-9s %9s %11s %13s %9s %11s%s %9s\n' "$name" "$solve" "$(total "$name" links)" "$(total "$name" rays)" \
    "$(stat_of "$work/$name.stats" all clusters)" "$(stat -c %s "$work/$name.strad")" "$(jumps "$work/$name.strad")" \
    "$([ -z "$finer" ] || compare finer "$name")"
}

# sides SCENE NAME OPTIONS...: the two sides of half time and what is between them, as a heat map.
sides() {
  local half picture=$STRAD_BENCH_PICTURES/$1-$2
  half=$(awk -v a="$(fact 'start s')" -v b="$(fact 'end s')" 'BEGIN { printf "%.9f,%.9f", (a + b) / 2 - 1e-7, (a + b) / 2 + 1e-7 }')
  strad-frame -q --direct mesh "${@:3}" -s 384x288 -t "$half" -o "$work/side.%04d.exr" "$work/clusters.strad"
  echo "jump in the picture $picture.png, percent: $(strad-diff --image "$picture.png" --rel-rmse 1e9 "$work/side.0001.exr" "$work/side.0002.exr" |
    value rel_rmse | awk '{ printf "%.3f", 100 * $1 }')"
}

for scene in ${STRAD_BENCH_CLUSTERS:-room4 halls-1000}; do
  echo "# $scene, -e $error: CPU s, counts, jump in percent at 1/4, 1/2 and 3/4 of the time: as solved, as frames show it"
  source_of "$scene" >"$work/scene.strad"
  if [ -n "$finer" ]; then
    strad-solve -q --no-clusters -e "$(awk -v e="$error" -v by="$finer" 'BEGIN { print e / by }')" "$work/scene.strad" >"$work/finer.strad"
  fi
  printf '%-9s %9s %11s %13s %9s %11s %9s %9s %9s %9s %9s %9s %9s\n' links_to solve_s links rays clusters bytes 1/4 1/2 3/4 1/4 1/2 3/4 \
    "${finer:+rel}"
  row clusters
  row surfaces --no-clusters
  echo "difference of the two in percent of the mean: $(compare surfaces clusters)"
  if [ -n "${STRAD_BENCH_PICTURES:-}" ]; then
    mkdir -p "$STRAD_BENCH_PICTURES"
    sides "$scene" solved --flat
    sides "$scene" shown
  fi
done
