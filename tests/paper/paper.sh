#!/bin/bash
# Repeats the experiments of the 2001 paper with strad and writes them as one page. `make paper` runs it.
#
#   paper.sh FOLDER                     FOLDER/index.html, beside the solutions, statistics and pictures it is made from
#   PAPER_SCENES='room4 clutter'        scenes of scenes/, or GENERATOR-N, for the paper's first scene and its second
#   PAPER_ERROR='0.02 0.02'             -e of each; a single number is that of both
#   PAPER_INSTANTS=3                    instants that are solved alone: their mean is the cost of one frame
#   PAPER_POINT=3,1.2,0,0,0,1           the point of figure 3, as strad-probe --at has it
#   PAPER_SIZE=320x240                  of pictures
#
# C. Damez, N. Holzschuch, F. X. Sillion, Space-Time Hierarchical Radiosity with Clustering and Higher-Order Wavelets,
# Eurographics Short Presentations, 2001.
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/../bench/measure.bash"
mkdir -p "$1"
folder=$(cd "$1" && pwd)
read -ra scenes <<<"${PAPER_SCENES:-room4 clutter}"
read -ra errors <<<"${PAPER_ERROR:-0.02}"
most_polygons=2000  # that links between surfaces only are tried for: their number grows with the square

rm -rf "$folder"/[12]
for ((i = 0; i < ${#scenes[@]} && i < 2; ++i)); do
  bash "$here/solve.sh" "${scenes[i]}" "${errors[i]:-${errors[0]}}" "${PAPER_INSTANTS:-3}" "$folder/$((i + 1))"
done

work=$folder/1
finer=$(awk -v e="${errors[0]}" 'BEGIN { print e / 4 }')
echo "${scenes[0]} with -e $finer, the reference of figure 3" >&2
strad-solve -q -e "$finer" -o "$work/reference.strad" "$work/scene.strad"
if [ "$(fact polygons)" -le $most_polygons ]; then
  echo "${scenes[0]} in basis m2 without clusters" >&2
  strad-solve -q -e "${errors[0]}" --basis m2 --no-clusters -o "$work/surfaces.strad" "$work/scene.strad"
fi

bash "$here/figures.sh" "$folder"
bash "$here/page.sh" "$folder" >"$folder/index.html"
echo "$folder/index.html" >&2
