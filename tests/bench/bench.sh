#!/bin/bash
# Measures strad as tables of ratios and counts: error against CPU seconds, acceleration over solving frame by frame at
# equal error, continuity in time; the error asked beside the error got, on hard scenes (errors.sh); growth with the scene
# (scale.sh), what clusters do (clusters.sh) and, where there is a truth, what POV-Ray needs (rivals.sh); what frames cost
# (frames.sh). `make bench` runs it.
#
#   STRAD_BENCH_TABLES='scenes errors scale clusters rivals frames'    which of these
#   STRAD_TRUTH=DIR make bench      DIR/SCENE/frame_%04d_a.exr and _b.exr: two halves of the truth, independent noise
#   STRAD_BENCH_SCENES='room4 cornell'   which scenes (scenes/SCENE), STRAD_BENCH_ERRORS='0.08 0.04 0.02 0.01'
#
# Without STRAD_TRUTH the reference is strad's own solution at a quarter of the smallest error, compared as solutions.
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/measure.bash"
tables=${STRAD_BENCH_TABLES:-scenes errors scale clusters rivals frames}
scenes=${STRAD_BENCH_SCENES:-room4 cornell}
errors=${STRAD_BENCH_ERRORS:-0.08 0.04 0.02 0.01}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

wanted() { [[ " $tables " == *" $1 "* ]]; }

wanted scenes || scenes=
for scene in $scenes; do
  echo
  echo "# $scene"
  rm -rf "$work"/*
  source_of "$scene" >"$work/scene.strad"
  if [ -d "${STRAD_TRUTH:-/nonexistent}/$scene" ]; then
    error_against_truth "$scene"
    acceleration "$scene"
  else
    error_against_itself
  fi
  continuity
done

for table in errors scale clusters rivals frames; do
  if wanted $table; then
    echo
    bash "$here/$table.sh"
  fi
done
