#!/bin/bash
# The whole pipeline on one scene, each command printed as a user would type it. `make demo` runs it.
#
#   demo.sh SCENE-FOLDER OUTPUT-FOLDER      the folder holds NAME.obj, NAME.mtl and NAME.motion
set -eu -o pipefail
scenes=$(cd "$(dirname "$0")" && pwd)
folder=$(cd "$1" && pwd)
name=$(basename "$folder")
mkdir -p "$2"
cd "$2"
cp "$folder/$name".{obj,mtl,motion} "$scenes/radiance.gnuplot" .

run() {
  echo
  echo "\$ $*"
  eval "$*"
}
section() {
  echo
  echo "# $*"
}

section "From an OBJ scene and a motion file to a solution for the whole animation"
run "strad-import $name.obj | strad-motion $name.motion > $name.scene"
run "strad-solve --stats $name.json $name.scene > $name.strad"
run "strad-info $name.strad"

section "Still pictures, and a movie straight down the pipe"
run "strad-frame -f 1:600:120 -s 640x480 -o '$name.%04d.png' $name.strad"
run "ffmpeg -y -loglevel error -pattern_type glob -i '$name.0*.png' -vf scale=300:-1,tile=5x1 -frames:v 1 sheet.png"
run "strad-frame -f 1:600:2 -s 320x240 --exposure 1 $name.strad |
    ffmpeg -y -loglevel error -f image2pipe -c:v ppm -r 12.5 -i - -pix_fmt yuv420p $name.mp4"

section "Indirect light over time at a point of the floor: functions that are constant in pieces against linear ones"
point=3,1.2,0,0,0,1
run "strad-solve -e 0.2 --basis m1 $name.scene | strad-probe --at $point -n 1200 --direct none --flat > m1.tsv"
run "strad-solve -e 0.2 --basis m2 $name.scene | strad-probe --at $point -n 1200 --direct none --flat > m2.tsv"
run "strad-probe --at $point -n 1200 --direct none $name.strad > smooth.tsv"
run "gnuplot radiance.gnuplot"

section "How much a solution jumps at half time"
run "strad-solve -e 0.2 --basis m1 $name.scene | strad-diff --jump 12 -"
run "strad-diff --jump 12 $name.strad"

section "The same animation for POV-Ray: geometry once, light frame by frame"
mkdir -p pov
run "strad-frame -f 1:600:150 -s 320x240 --pov -o 'pov/$name.%04d.inc' $name.strad"
run "(cd pov && povray $name.ini 2> povray.log) || tail pov/povray.log"

echo
echo "All of it is in $PWD"
