#!/bin/bash
# How many of POV-Ray's example scenes import: strictly, with --skip-unknown, or not at all, and why not.
#
#   povray_examples.sh [FOLDER]   the scenes below FOLDER; /usr/share/doc/povray/examples (povray-examples) without it
#   KEEP=FILE                     keep the table: file, strict, skip or refused, CPU seconds, and the reason or -
#
# A scene that kills the tool, takes more than LIMIT (60) seconds by the clock or 4 GB counts as `died`; on a busy machine
# raise LIMIT.
# A reason is the first thing that is refused: files that lack several things are counted under one of them.
set -eu -o pipefail
export LC_ALL=C
folder=${1:-/usr/share/doc/povray/examples}
table=${KEEP:-$(mktemp)}
[ -n "${KEEP:-}" ] || trap 'rm -f "$table"' EXIT
[ -d "$folder" ] || { echo "no folder $folder; Debian has it in povray-examples" >&2; exit 2; }

# try OPTIONS... FILE: prints its exit status, CPU seconds and its last line of errors.
try() (
  ulimit -v 4000000
  TIMEFORMAT='%U'
  cd "$(dirname "${*: -1}")"
  exec 3>&1
  { time { timeout "${LIMIT:-60}" strad-import -q "${@:1:$#-1}" "$(basename "${*: -1}")" 2>&1 >/dev/null | tail -1 >&3
           echo "${PIPESTATUS[0]}" >&3; }; } 2>&1
)
export -f try

judge() {
  local file=$1 reason='-' how=strict last=() status
  mapfile -t last < <(try "$file")
  # Two or three lines: perhaps a reason, the status, the seconds.
  status=${last[-2]}
  if [ "$status" != 0 ]; then
    [ ${#last[@]} -lt 3 ] || reason=${last[0]}
    mapfile -t last < <(try --skip-unknown --skip-missing "$file")
    how=skip
    if [ "${last[-2]}" = 2 ] && [ ${#last[@]} = 3 ]; then
      how=refused reason=${last[0]}
    elif [ "${last[-2]}" != 0 ]; then
      how=died reason="status ${last[-2]}"
    fi
    [ "$status" = 2 ] || how=died reason="strictly: status $status"
  fi
  printf '%s\t%s\t%s\t%s\n' "${file#"$2"/}" "$how" "${last[-1]}" "$reason"
}
export -f judge

find "$folder" -name '*.pov' -print0 | sort -z | xargs -0 -P "${JOBS:-2}" -I{} bash -c 'judge "$1" "$2"' _ {} "$folder" >"$table"
sort -o "$table" "$table"

for how in strict skip refused died; do
  printf '%s\t%d\n' $how "$(awk -F'\t' -v how=$how '$2 == how' "$table" | wc -l)"
done
# Reasons without the name of the program, file and line.
for how in skip refused; do
  echo
  echo "# why not $([ $how = skip ] && echo strictly || echo 'at all'): scenes, reason"
  awk -F'\t' -v how=$how '$2 == how { print $4 }' "$table" |
    sed -E 's/^strad-import: //; s/^[^ ]*:[0-9]+: //' | sort | uniq -c | sort -k1,1nr -k2
done
