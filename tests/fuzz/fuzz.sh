# fuzz.sh BUILD MINUTES: runs every fuzzer for MINUTES, as many at a time as there are cores, from the committed corpus and
# what earlier runs added to BUILD/corpus. Prints a line for each: inputs tried, what is covered, and whether it found
# something. Finds are in BUILD/finds; exit status 1 if there are any. Put the input of a mended find into tests/fuzz/corpus.
set -eu
cd "$(dirname "$0")/../.."
build=$1 minutes=$2
mkdir -p "$build/finds"

fuzz_one() {  # fuzz_one BUILD MINUTES TARGET
  local build=$1 minutes=$2 target=$3 status=0
  mkdir -p "$build/corpus/$target"
  # An input of 4096 bytes takes no longer than 10 s and no more than 2 GB, or is a find.
  UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=0 \
    "$build/fuzzers/fuzz_$target" -max_total_time=$((60 * minutes)) -max_len=4096 -timeout=10 -rss_limit_mb=2048 \
    -print_final_stats=1 -artifact_prefix="$build/finds/$target-" "$build/corpus/$target" \
    "tests/fuzz/corpus/$target" >"$build/$target.log" 2>&1 || status=$?
  awk -v target="$target" -v status="$status" '
    / cov: / { for (i = 1; i < NF; ++i) { if ($i == "cov:") covered = $(i + 1) } }
    /number_of_executed_units/ { tried = $2 }
    END { printf "%-8s %9d inputs, %5d edges%s\n", target, tried, covered, status ? ": a find, see " target ".log" : "" }
  ' "$build/$target.log"
}
export -f fuzz_one

ls "$build"/fuzzers | sed -n 's/^fuzz_//p' |
  xargs -P "$(nproc)" -I TARGET bash -c 'fuzz_one "$@"' fuzz "$build" "$minutes" TARGET
test -z "$(ls -A "$build/finds")"
