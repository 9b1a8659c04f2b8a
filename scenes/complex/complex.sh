#!/bin/bash
# The second scene of the 2001 paper: the room of ../room4, its lights, its camera and its motion, with complex models
# of about N polygons in all (from 5000) in place of its four boxes. Two of them move.
#
#   complex.sh N FOLDER      writes FOLDER/NAME.obj, NAME.mtl and NAME.motion, where NAME is the folder's own name
#
# The same N gives the same bytes everywhere.
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)

if [ $# -ne 2 ] || ! [[ $1 =~ ^([5-9][0-9]{3}|[1-9][0-9]{4,6})$ ]]; then
  echo "usage: complex.sh N FOLDER    with N from 5000 to 9999999" >&2
  exit 2
fi
mkdir -p "$2"
name=$2/$(basename "$(cd "$2" && pwd)")

cp "$here/complex.mtl" "$name.mtl"
cat "$here/../room4/room4.motion" "$here/turning.motion" >"$name.motion"
awk -v polygons="$1" -v library="$(basename "$name").mtl" \
  -f "$here/../halls/solids.awk" -f "$here/turned.awk" -f "$here/complex.awk" >"$name.obj"
