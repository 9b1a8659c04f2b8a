#!/bin/bash
# Halls of furniture and machines, of exactly N polygons (from 1000), parts of which move: a scene that scales.
#
#   halls.sh N FOLDER      writes FOLDER/NAME.obj, NAME.mtl and NAME.motion, where NAME is the folder's own name
#
# The same N gives the same bytes everywhere. Number and richness of the halls both grow as the square root of N.
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)

if [ $# -ne 2 ] || ! [[ $1 =~ ^[1-9][0-9]{3,7}$ ]]; then
  echo "usage: halls.sh N FOLDER    with N from 1000 to 99999999" >&2
  exit 2
fi
mkdir -p "$2"
name=$2/$(basename "$(cd "$2" && pwd)")

cp "$here/halls.mtl" "$name.mtl"
awk -v polygons="$1" -v library="$(basename "$name").mtl" -v motion="$name.motion" \
  -f "$here/solids.awk" -f "$here/furniture.awk" -f "$here/halls.awk" >"$name.obj"
