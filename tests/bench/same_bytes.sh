#!/bin/bash
# Do two builds make the same bytes? Streams, frames, exports, probes and descriptions of some scenes, file by file.
#
#   same_bytes.sh OLD NEW [SCENE...]     OLD, NEW: folders with the executables of a build, or folders that an
#                                        earlier call has kept; SCENE: of scenes/, or GENERATOR-N such as halls-1000
#   KEEP=DIR                             keep what NEW has made in DIR, to stand for OLD later (OLD may be NEW then)
#
# A change of the layout of the code must pass this; a change of what is computed cannot.
set -eu -o pipefail
here=$(cd "$(dirname "$0")" && pwd)
[ $# -ge 2 ] || { sed -n '2,8s/^# \{0,1\}//p' "$0" >&2; exit 2; }
old=$(cd "$1" && pwd) new=$(cd "$2" && pwd)
shift 2
[ $# -gt 0 ] || set -- room4 cornell halls-1000 clutter
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# source_of SCENE FOLDER: copies or generates the files of a scene.
source_of() {
  mkdir -p "$2"
  if [[ $1 =~ ^(.*)-([0-9]+)$ ]]; then
    "$here/../../scenes/${BASH_REMATCH[1]}/${BASH_REMATCH[1]}.sh" "${BASH_REMATCH[2]}" "$2/$1"
    mv "$2/$1"/* "$2"
  else
    cp "$here/../../scenes/$1/$1".{obj,mtl,motion} "$2"
  fi
}

# make_all BIN SCENE FOLDER: everything that the tools of BIN make of a scene.
make_all() (
  local scene=$2
  PATH=$1:$PATH
  source_of "$scene" "$3"
  cd "$3"
  strad-import -q "$scene.obj" | strad-motion -q "$scene.motion" >scene.stream
  strad-solve -q scene.stream >solved.stream
  strad-solve -q -e 0.3 --basis m2 --at 1 scene.stream >instant.stream
  strad-info solved.stream >info.txt
  strad-info --json solved.stream >info.json
  strad-probe -q --at 1,1,1 --at 3,2,0.5,0,0,1 -n 50 solved.stream >probe.tsv
  strad-frame -q -f 1:200:60 -s 160x120 -o 'pixel.%04d.exr' solved.stream
  strad-frame -q -f 2:200:90 -s 160x120 --shutter 0.5 -o 'blur.%04d.png' solved.stream
  strad-frame -q -f 10:100:30 -s 160x120 --direct mesh --pfm solved.stream >mesh.pfm
  strad-frame -q -f 10 -s 160x120 --direct mesh --flat solved.stream >flat.ppm
  strad-frame -q -f 1:50:20 --ply -o 'mesh.%04d.ply' solved.stream
  for direct in mesh pixel; do
    mkdir "pov_$direct"
    strad-frame -q -f 1:50:20 --pov --direct "$direct" -o "pov_$direct/p.%04d.inc" solved.stream
  done
)

status=0
for scene in "$@"; do
  for side in new old; do
    from=${!side}
    if [ "$side" = old ] && [ "$old" = "$new" ]; then
      ln -s "$work/$scene.new" "$work/$scene.old"
    elif [ -d "$from/$scene" ]; then
      ln -s "$from/$scene" "$work/$scene.$side"
    else
      make_all "$from" "$scene" "$work/$scene.$side"
    fi
  done
  if diff -rq "$work/$scene.old/" "$work/$scene.new/"; then
    echo "$scene: $(find "$work/$scene.new/" -type f | wc -l) files are the same"
  else
    status=1
  fi
  if [ -n "${KEEP-}" ]; then
    mkdir -p "$KEEP"
    rm -rf "${KEEP:?}/$scene"
    cp -r "$work/$scene.new/" "$KEEP/$scene"
  fi
done
exit $status
