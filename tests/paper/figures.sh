#!/bin/bash
# The pictures of the page: figures 2 to 5 of the paper, from the solutions that paper.sh left in FOLDER.
#
#   figures.sh FOLDER
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/../bench/measure.bash"
size=${PAPER_SIZE:-320x240}
point=${PAPER_POINT:-3,1.2,0,0,0,1}
folder=$1

# pixels FILE: one line `red green blue` per pixel of a PFM picture, rows from below.
pixels() { tail -n +4 "$1" | od -An -v -t f4 -w12; }

# sides NAME: the two sides of half time as strad solved them, and what is between them in percent of their mean.
sides() {
  local name=$1 time
  time=$(awk -v half="$(value half <"$work/facts")" 'BEGIN { printf "%.9f,%.9f", half - 1e-6, half + 1e-6 }')
  strad-frame -q --flat --direct mesh -s "$size" -t "$time" --exposure 1 -o "$work/$name-side-%d.png" "$work/$name.strad"
  strad-frame -q --flat --direct mesh -s "$size" -t "$time" -o "$work/side-%d.pfm" "$work/$name.strad"
  paste <(pixels "$work/side-1.pfm") <(pixels "$work/side-2.pfm") |
    awk -v columns="${size%x*}" -f "$here/difference.awk" >"$work/$name-difference.tsv"
  gnuplot -e "data='$work/$name-difference.tsv'; picture='$work/$name-difference.png'" \
    -e "columns=${size%x*}; rows=${size#*x}" "$here/difference.gnuplot"
  strad-diff --jump "$(value half <"$work/facts")" "$work/$name.strad" >"$work/$name.jump"
}

# frames: six frames evenly spaced, none at the ends.
frames() {
  local count i
  count=$(value frames <"$work/facts")
  for i in 1 2 3 4 5 6; do
    strad-frame -q -s "$size" -f $(((2 * i - 1) * count / 12)) --exposure 1 -o "$work/frame-$i.png" "$work/m3.strad"
  done
}

for work in "$folder"/[12]; do
  for stream in "$work"/m?.strad "$work"/surfaces.strad; do
    [ ! -e "$stream" ] || sides "$(basename "$stream" .strad)"
  done
  frames
done

work=$folder/1
for basis in m1 m2; do
  strad-probe -q --at "$point" -n 2401 --direct none --flat -o "$work/radiance-$basis.tsv" "$work/$basis.strad"
done
strad-probe -q --at "$point" -n 2401 --direct none -o "$work/radiance-reference.tsv" "$work/reference.strad"
gnuplot -e "folder='$work'; half=$(value half <"$work/facts"); seconds=$(value seconds <"$work/facts")" \
  "$here/radiance.gnuplot"
