#!/bin/bash
# Writes an animated glTF file: orrery.sh FILE.glb.
#
#   orrery.sh orrery.glb && strad-import orrery.glb | strad-solve > orrery.strad
set -eu
[ $# = 1 ] || { echo "usage: orrery.sh FILE.glb" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
LC_ALL=C awk -v bin="$work/octal" -f "$(dirname "$0")/orrery.awk" >"$work/json"
printf '%b' "$(cat "$work/octal" | sed 's/\\/\\0/g')" >"$work/bin"
while (($(stat -c %s "$work/json") % 4)); do printf ' ' >>"$work/json"; done
word() { printf "$(printf '\\%03o\\%03o\\%03o\\%03o' $(($1 & 255)) $(($1 >> 8 & 255)) $(($1 >> 16 & 255)) $(($1 >> 24)))"; }
json=$(stat -c %s "$work/json") bin=$(stat -c %s "$work/bin")
{
  printf 'glTF'; word 2; word $((12 + 8 + json + 8 + bin))
  word "$json"; printf 'JSON'; cat "$work/json"
  word "$bin"; printf 'BIN\0'; cat "$work/bin"
} >"$1"
