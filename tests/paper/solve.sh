#!/bin/bash
# Solves a scene as the paper's tables need it: in each basis, and single instants for what solving frame by frame costs.
#
#   solve.sh SCENE ERROR INSTANTS FOLDER    FOLDER gets scene.strad, BASIS.strad and .json, instant-K.json, facts
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/../bench/measure.bash"
scene=$1 error=$2 instants=$3 work=$4
mkdir -p "$work"

source_of "$scene" >"$work/scene.strad"
start=$(fact 'start s')
end=$(fact 'end s')
{
  echo "scene $scene"
  echo "error $error"
  echo "polygons $(fact polygons)"
  echo "frames $(fact frames)"
  echo "instants $instants"
  awk -v a="$start" -v b="$end" 'BEGIN { printf "seconds %.9g\nhalf %.9g\n", b - a, (a + b) / 2 }'
} >"$work/facts"

# Instants evenly spaced, none at the ends: the Kth of N stands in the middle of the Kth Nth of the time.
for ((k = 1; k <= instants; ++k)); do
  time=$(awk -v a="$start" -v b="$end" -v n="$instants" -v k=$k 'BEGIN { printf "%.9g", a + (b - a) * (k - 0.5) / n }')
  echo "$scene at $time s" >&2
  strad-solve -q -e "$error" --at "$time" --stats "$work/instant-$k.json" -o "$work/instant.strad" "$work/scene.strad"
done
for basis in m1 m2 m3; do
  echo "$scene in basis $basis" >&2
  strad-solve -q -e "$error" --basis $basis --stats "$work/$basis.json" -o "$work/$basis.strad" "$work/scene.strad"
done
