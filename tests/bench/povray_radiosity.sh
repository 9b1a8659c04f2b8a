#!/bin/bash
# Frames of a POV-Ray animation by strad and by POV-Ray's own radiosity, from the very same .ini.
#
#   povray_radiosity.sh [SCENE.ini [FRAME...]]   scenes/crane/crane.ini and three of its frames without arguments
#   SIZE=160x120                                 of the pictures
#   ERROR=0.02                                   -e of strad-solve
#   RADIOSITY='count 200 error_bound 0.4 recursion_limit 8'    POV-Ray's settings, in place of the scene's
#   LAMP=0.3                                     pixels brighter than this in strad's frame show a lamp, which POV-Ray has no
#                                                picture of: they are not compared
#   KEEP=FOLDER                                  keep the pictures: strad.N.exr, povray.N.exr
#
# Prints for each frame the relative RMSE between the two and the mean of strad's over that of POV-Ray's. They differ where
# POV-Ray has what strad leaves out (strad-import says what), and by the errors of both. Needs povray.
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)
ini=$(realpath "${1:-$here/../../scenes/crane/crane.ini}")
[ $# -gt 0 ] && shift
command -v povray >/dev/null || { echo "povray is missing; Debian has it in povray" >&2; exit 2; }
size=${SIZE:-160x120}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
keep=${KEEP:-$work}
mkdir -p "$keep"

setting() { sed -nE "s/^ *$1 *= *\"?([^\" ]*)\"?.*/\1/Ip" "$ini" | tail -1; }
scene=$(setting Input_File_Name)
last=$(setting Final_Frame)
[ $# -gt 0 ] || set -- 1 $((last / 2)) "$last"

strad-import -q "$ini" | strad-solve -q -e "${ERROR:-0.02}" >"$work/scene.strad"

# The scene with radiosity, beside the original: what it includes is found there.
folder=$(dirname "$ini")
{
  echo "#version 3.7;"
  echo "#include \"$scene\""
  echo "global_settings { assumed_gamma 1 radiosity { ${RADIOSITY:-count 200 error_bound 0.4 recursion_limit 8} } }"
} >"$work/radiosity.pov"

echo "frame rel_rmse_% mean_ratio"
for frame in "$@"; do
  strad-frame -q -f "$frame" -s "$size" -o "$keep/strad.$frame.exr" "$work/scene.strad"
  (cd "$folder" && povray "$(basename "$ini")" "+I$work/radiosity.pov" "+L$folder" "+W${size%x*}" "+H${size#*x}" \
    +FE +A0.1 -D "+SF$frame" "+EF$frame" "+O$work/made.exr" >"$work/log" 2>&1) ||
    { tail -20 "$work/log" >&2; exit 1; }
  mv "$work"/made*.exr "$keep/povray.$frame.exr"  # POV-Ray puts the frame's number into the name
  # Scaled so that LAMP is half of the darkest step of 8 bits on the sRGB curve, all that is darker is 0.
  stops=$(awk -v lamp="${LAMP:-0.3}" 'BEGIN { print log(0.5 / 255 / 12.92 / lamp) / log(2) }')
  strad-frame -q -f "$frame" -s "$size" --exposure "$stops" -o "$work/lamps.png" "$work/scene.strad"
  { strad-diff --ignore "$work/lamps.png" "$keep/povray.$frame.exr" "$keep/strad.$frame.exr" || [ $? = 1 ]; } |
    awk -v frame="$frame" '$1 == "rel_rmse" { rel = $2 } $1 == "mean_a" { a = $2 } $1 == "mean_b" { b = $2 }
      END { printf "%d %.1f %.3f\n", frame, 100 * rel, b / a }'
done
