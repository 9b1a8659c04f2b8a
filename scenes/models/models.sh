#!/bin/bash
# Real models in a lit room: from Debian's assimp-testmodels a beast that walks, a spider on a turntable and a house on a
# table, from its povray-examples two vases.
#
#   models.sh FOLDER      writes FOLDER/NAME.obj, NAME.mtl and NAME.motion, where NAME is the folder's own name
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
assimp=${ASSIMP_MODELS:-/usr/share/assimp/models/OBJ}
povray=${POVRAY_SCENES:-/usr/share/doc/povray/examples}

if [ $# -ne 1 ]; then
  echo "usage: models.sh FOLDER" >&2
  exit 2
fi
for file in "$assimp"/{WusonOBJ,spider,regr01}.obj "$povray"/camera/mesh_camera/vase{1,2}.inc; do
  [ -r "$file" ] || { echo "models.sh: no $file: install assimp-testmodels and povray-examples" >&2; exit 2; }
done
mkdir -p "$1"
name=$1/$(basename "$(cd "$1" && pwd)")

place() {  # place FILE VARIABLE=VALUE...
  local file=$1 arguments=()
  shift
  for variable in "$@"; do arguments+=(-v "$variable"); done
  awk "${arguments[@]}" -f "$here/place.awk" "$file"
}
# Materials of a model: its colours under its name, without gloss and textures.
colours() {
  tr -d '\r' <"$2" | awk -v name="$1" '
  $1 == "newmtl" { gsub(/[^-A-Za-z0-9_]/, "_", $2); print "\nnewmtl " name "_" $2 }
  $1 == "Kd" { print }'
}

{
  awk -v library="$(basename "$name").mtl" -f "$here/../halls/solids.awk" -f "$here/room.awk"
  place "$assimp/WusonOBJ.obj" name=beast x=2 y=1.4 z=0.004 size=2 turn=0 up=y colour=fur
  place "$assimp/spider.obj" name=spider x=5.3 y=1.7 z=0.434 size=1.1 turn=30 up=y colour=clay palette="$assimp/spider.mtl"
  place "$assimp/regr01.obj" name=house x=5.9 y=4.3 z=0.7 size=1.8 turn=0 up=z colour=wall palette="$assimp/regr01.mtl"
  place "$povray/camera/mesh_camera/vase1.inc" name=vase1 x=7 y=1 z=0.8 size=0.6 turn=0 up=y colour=clay
  place "$povray/camera/mesh_camera/vase2.inc" name=vase2 x=0.9 y=5.1 z=0.8 size=0.6 turn=0 up=y colour=blue
} >"$name.obj"
{
  cat "$here/models.mtl"
  colours spider "$assimp/spider.mtl"
  colours house "$assimp/regr01.mtl"
} >"$name.mtl"
cp "$here/models.motion" "$name.motion"
