#!/bin/bash
# The page of `make paper` to standard output: tables and figures of the paper from what paper.sh left in FOLDER. All
# pictures are in the page itself.
#
#   page.sh FOLDER
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
source "$here/../bench/measure.bash"
folder=$1

told() { value "$2" <"$folder/$1/facts"; }  # told NUMBER NAME: a fact of the paper's first or second scene

# measures NUMBER: the lines of paper.tsv as strad has them; seconds of one frame alone are means.
measures() {
  local basis
  for basis in m1 m2 m3; do
    row "$1" $basis "$(told "$1" frames)" "$folder/$1/$basis.json"
  done
  row "$1" frame 1 "$folder/$1"/instant-*.json
}

row() {  # row NUMBER NAME FRAMES STATS...: the mean of all statistics
  local stats
  for stats in "${@:4}"; do
    echo "$(stat_of "$stats" direct cpu_seconds) $(stat_of "$stats" indirect cpu_seconds)" \
      "$(stat_of "$stats" total cpu_seconds) $(stat_of "$stats" bytes peak)"
  done | awk -v number="$1" -v name="$2" -v frames="$3" '
    function text(x) { return sprintf(x >= 100 ? "%.0f" : x >= 10 ? "%.1f" : x >= 1 ? "%.2f" : "%#.2g", x) }
    { direct += $1; indirect += $2; total += $3; peak += $4 }
    END {
      printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\n", number, name, text(direct / NR), text(indirect / NR), text(total / NR),
        text(total / NR / frames), text(peak / NR / 1e6)
    }'
}

percent() { awk -v x="$1" 'BEGIN { printf "%.2f&#160;%%", 100 * x }'; }

jump() { percent "$(value "${3:-jump}" <"$folder/$1/$2.jump")"; }  # jump NUMBER SOLUTION [jump_continuous]

# picture FILE ALTERNATIVE: a PNG or SVG within the page.
picture() {
  local type=png
  [[ $1 != *.svg ]] || type=svg+xml
  printf '<img alt="%s" src="data:image/%s;base64,%s"/>\n' "$2" $type "$(base64 -w0 "$folder/$1")"
}

panel() {  # panel FILE TEXT
  printf '<div class="panel">\n%s\n<p>%s</p>\n</div>\n' "$(picture "$1" "$2")" "$2"
}

figure() {  # figure NUMBER CAPTION <CONTENTS
  printf '<div class="figure" id="figure-%s">\n<div class="panels">\n' "$1"
  cat
  printf '</div>\n<p class="caption"><b>Figure %s.</b> %s</p>\n</div>\n' "$1" "$2"
}

table() {  # table NUMBER CAPTION
  local caption=$2 measured=/dev/null frames=0
  if [ -d "$folder/$1" ]; then
    measures "$1" >"$folder/$1/measures.tsv"
    measured=$folder/$1/measures.tsv
    frames=$(told "$1" frames)
    caption+=" strad: scene $(told "$1" scene), $(told "$1" polygons) polygons, $(told "$1" frames) frames, -e $(told "$1" error)."
  else
    caption+=" strad was not run on a second scene."
  fi
  awk -v table="$1" -v frames="$frames" -v caption="$caption" -f "$here/table.awk" "$here/paper.tsv" "$measured"
}

basis_name() {
  case $1 in
    m1) echo 'constant (Haar)' ;;
    m2) echo 'M2' ;;
    m3) echo 'M3' ;;
    surfaces) echo 'M2, no clusters' ;;
  esac
}

figure_2() {
  local basis
  for basis in m1 m2; do
    panel "1/$basis-side-1.png" "$(basis_name $basis), just before"
    panel "1/$basis-side-2.png" "$(basis_name $basis), just after"
    panel "1/$basis-difference.png" "$(basis_name $basis), difference"
  done
}

figure_4() {
  local number name
  for number in 1 2; do
    for name in m1 m2 m3 surfaces; do
      [ ! -e "$folder/$number/$name-difference.png" ] ||
        panel "$number/$name-difference.png" "$(told $number scene), $(basis_name $name): jump $(jump $number $name)"
    done
  done
}

figure_5() {
  local number i
  for number in 1 2; do
    for i in 1 2 3 4 5 6; do
      [ ! -e "$folder/$number/frame-$i.png" ] ||
        panel "$number/frame-$i.png" "$(told $number scene), frame $(((2 * i - 1) * $(told $number frames) / 12))"
    done
  done
}

half=$(told 1 half)
processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2>/dev/null | sort -u | paste -sd,)
continuous=$(jump 1 m3 jump_continuous)
clusters=
[ ! -e "$folder/1/surfaces.jump" ] ||
  clusters=" Without clusters M2 jumps by $(jump 1 surfaces) on the first scene, with them by $(jump 1 m2)."
[ ! -e "$folder/2" ] ||
  clusters+=" On the second scene, which has many clusters, M2 jumps by $(jump 2 m2) and the constant basis by $(jump 2 m1)."

cat <<EOF
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<title>Space-time hierarchical radiosity: the paper of 2001 and strad</title>
<style>
body { font: 15px/1.45 sans-serif; max-width: 1240px; margin: 2em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; margin: 1em 0; }
th, td { border: 1px solid #ccc; padding: 0.25em 0.5em; text-align: right; font-weight: normal; }
th:first-child { text-align: left; }
.panels { display: flex; flex-wrap: wrap; gap: 0.6em; }
.panel p { margin: 0.2em 0; font-size: 13px; }
.caption { max-width: 60em; margin-bottom: 2.5em; }
img { max-width: 100%; display: block; }
</style>
</head>
<body>
<h1>Space-time hierarchical radiosity: the paper of 2001 and strad</h1>
<p>The tables and figures of C. Damez, N. Holzschuch and F. X. Sillion, <i>Space-Time Hierarchical Radiosity with
Clustering and Higher-Order Wavelets</i>, Eurographics Short Presentations, 2001 (HAL inria-00441617), made again with
strad. <code>make paper</code> writes this page. The scenes are strad's own, built after the paper's description:
its models are not published.</p>
<p>The paper's seconds are those of a 300 MHz MIPS R12000, strad's those of one program on ${processor:-this machine}, $(nproc)
processors, summed over all threads. 25 years lie between the machines, so seconds and megabytes of the
two cannot be compared with each other. Their ratios can: each is of two runs on one machine.</p>
<p>The algorithms differ too. Both link clusters and surfaces over intervals of time. strad then gathers indirect light by rays
at the vertices of a mesh, which takes most of its time, and corrects what jumps in time when it makes frames. Where this page
says <i>as solved</i>, the correction is off, and all light is taken from the elements of the mesh and
their functions of time.</p>
$(table 1 "CPU seconds and memory on the first scene, a closed room with four boxes and four moving spotlights. Acceleration is \
the time of all frames, each alone, over the time of the whole animation at the same tolerated error. The total of strad has \
the preparation of the scene in it. A frame alone is the mean of $(told 1 instants) instants (strad-solve --at). In the paper's text M2 takes 15 % more \
memory than the constant basis; in its table it takes 21 % less.")
$(table 2 "The same on the second scene, with complex models in place of the boxes and links between clusters. The paper \
has no constant basis here.")
$(figure_2 | figure 2 "Frames just before and just after half time, t&#160;=&#160;$half&#160;s, as solved, and the difference of the two: \
the darker, the larger, in percent of the mean of the picture. The frames are two microseconds apart, so each difference \
is an error. With the constant basis look for patches all over the scene that change at once: by $(jump 1 m1) of \
the mean radiance (root of the mean square over all surfaces, strad-diff --jump $half). With M2 they change by $(jump 1 m2).")
$({
  picture 1/radiance.svg "radiance at a point over the animation"
  picture 1/radiance-half.svg "the same near half time"
} | figure 3 "Radiance from indirect light at the point ${PAPER_POINT:-3,1.2,0,0,0,1} over the whole animation, and near half time. The \
constant basis goes in steps; M2 follows the reference in straight pieces that do not quite meet. The \
reference is a solution in M3 at a fourth of the tolerated error, as frames show it. What lies between it and the other two \
is error: in part that of -e, in part because an element has one value and the reference that of the point.")
$(figure_4 | figure 4 "Differences at half time as in figure 2, by basis. Each jump is the root of the mean square over all surfaces, \
in percent of the mean radiance. The paper finds that clusters bring back some of the jumps.$clusters In frames as strad shows \
them, with the correction, M3 jumps by $continuous on the first scene.")
$(figure_5 | figure 5 "Frames of the animations, solved in M3, with direct light per pixel.")
</body>
</html>
EOF
