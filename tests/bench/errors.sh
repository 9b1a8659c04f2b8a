#!/bin/bash
# The error that was asked for beside the error that was got, as strad-check measures it by unbiased paths, on small scenes
# of the kinds that are hard for a solver and on those of scenes/: all surfaces and times by area.
#
#   STRAD_BENCH_TRIALS='trials-doors cornell'    scenes, or GENERATOR-NAME
#   STRAD_BENCH_TRIALS_ERRORS='0.5 0.08 0.04 0.02 0.01'    -e
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/measure.bash"
errors=${STRAD_BENCH_TRIALS_ERRORS:-0.5 0.08 0.02}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# of NAME KEY: value, low or high of rel_rmse or bias of the whole, in what strad-check --json wrote.
of() { tr -d ' \n' <"$work/check.json" | grep -o "\"$1\":{[^}]*}" | sed -n "1s/.*\"$2\":\([^,}]*\).*/\1/p"; }
percent() { awk '{ printf "%.2f\n", 100 * $1 }'; }

echo "# error asked and got, all in percent, with the 95 % interval of the latter; got / asked; CPU s of the solve"
printf '%-14s %6s %7s %8s %8s %8s %7s %8s\n' scene asked got low high bias ratio solve_s
for scene in ${STRAD_BENCH_TRIALS:-trials-doors trials-belt trials-beams trials-fan trials-statue trials-slit room4 cornell}; do
  rm -rf "$work"/*
  source_of "$scene" >"$work/scene.strad"
  for error in $errors; do
    solve=$(cpu "$work/solved.strad" strad-solve -q -e "$error" "$work/scene.strad")
    strad-check -q --json -o "$work/check.json" "$work/solved.strad"
    got=$(of rel_rmse value)
    printf '%-14s %6s %7s %8s %8s %8s %7s %8s\n' "$scene" "$(percent <<<"$error")" "$(percent <<<"$got")" \
      "$(of rel_rmse low | percent)" "$(of rel_rmse high | percent)" \
      "$(of bias value | percent)" "$(awk -v a="$got" -v b="$error" 'BEGIN { printf "%.2f", a / b }')" "$solve"
  done
done
