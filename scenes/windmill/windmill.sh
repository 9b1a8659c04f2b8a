#!/bin/bash
# Writes an animation as numbered OBJ files, as Blender does: windmill.sh N FOLDER makes N files, 25 a second.
#
#   windmill.sh 101 frames && strad-import -f 1:101 'frames/windmill.%04d.obj' | strad-solve > windmill.strad
set -eu
[ $# = 2 ] || { echo "usage: windmill.sh N FOLDER" >&2; exit 2; }
here=$(dirname "$0")
mkdir -p "$2"
cp "$here/windmill.mtl" "$2"
for ((frame = 1; frame <= $1; ++frame)); do
  awk -v t="$(awk -v k="$frame" 'BEGIN { printf "%.17g", (k - 1) / 25 }')" -f "$here/windmill.awk" \
    >"$2/windmill.$(printf %04d "$frame").obj"
done
