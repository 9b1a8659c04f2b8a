# What the programs of tests/bench measure; they set `here` and `work`, bench.sh also `errors`.

TIMEFORMAT='%U %S'

# cpu OUTPUT COMMAND...: runs it with standard output to OUTPUT and prints its CPU seconds.
cpu() {
  local output=$1
  shift
  { time "$@" >"$output" 2>"$work/log" || { cat "$work/log" >&2; exit 1; }; } 2>&1 | awk '{ printf "%.3f\n", $1 + $2 }'
}

# value NAME <TEXT: the value on the line `NAME value`.
value() { awk -v name="$1" '$1 == name { print $2 }'; }

# source_of SCENE: a scene of scenes/, or GENERATOR-N for one that scenes/GENERATOR/GENERATOR.sh makes, of N polygons or
# under the name N.
source_of() {
  local folder=$here/../../scenes/$1
  if [[ $1 =~ ^([a-z]+)-([0-9a-z]+)$ ]]; then
    folder=$work/$1
    "$here/../../scenes/${BASH_REMATCH[1]}/${BASH_REMATCH[1]}.sh" "${BASH_REMATCH[2]}" "$folder"
  fi
  strad-import -q "$folder/$1.obj" | strad-motion -q "$folder/$1.motion"
}

# stat_of FILE GROUP NAME: a number of what strad-solve --stats wrote; GROUP is `all` for those outside of groups.
stat_of() {
  tr -d ' \n' <"$1" | awk -v group="$2" -v name="$3" '{
    if (group == "all") gsub(/"[a-z_]*":[{][^}]*[}],?/, "")
    else { sub(".*\"" group "\":[{]", ""); sub(/[}].*/, "") }
    if (match($0, "\"" name "\":[^,}]*")) print substr($0, RSTART + length(name) + 3, RLENGTH - length(name) - 3) + 0
    else print "-"
  }'
}

# fact NAME: a number of strad-info that has this name.
fact() { strad-info --json "$work/scene.strad" | awk -F'[:,]' -v key="\"$1\"" '!told && index($1, key) { print $2 + 0; told = 1 }'; }

# The truth's frame numbers, with commas, and its picture size (PFM has it as text).
truth_frames() { ls "$STRAD_TRUTH/$1" | sed -n 's/^frame_0*\([0-9]*\)_a\.exr$/\1/p' | paste -sd, -; }
truth_size() {
  case $1 in
    cornell) echo 160x160 ;;
    *) echo 192x144 ;;
  esac
}

# rel SCENE PATTERN FRAMES: error of frames in percent, the truth's noise taken out.
rel() {
  local truth=$STRAD_TRUTH/$1 ignore=()
  if [ "$(ls "$truth" | grep -c '^labels_')" = "$(ls "$truth" | grep -c '_a\.exr$')" ]; then
    ignore=(--ignore "$truth/labels_%04d.png" --ignore-bits 9)
  fi
  strad-diff "$truth/frame_%04d_a.exr" "$2" --twin "$truth/frame_%04d_b.exr" -f "$3" "${ignore[@]}" --rel-rmse 1e9 |
    value rel_rmse | awk '{ printf "%.2f\n", 100 * $1 }'
}

# render OUTPUT-PATTERN SIZE FRAMES STREAM OPTIONS...: prints CPU seconds a frame, each by a process of its own.
render() {
  local pattern=$1 size=$2 frames=$3 stream=$4 frame
  shift 4
  for frame in ${frames//,/ }; do
    cpu /dev/null strad-frame -q -s "$size" -f "$frame" -o "$pattern" "$@" "$stream"
  done | mean
}

error_against_truth() {
  local scene=$1 frames size error solve mesh pixel rel_mesh rel_pixel
  frames=$(truth_frames "$scene")
  size=$(truth_size "$scene")
  echo "# error against the truth in percent, direct light from the mesh and per pixel; CPU s of the solve and of one frame"
  printf '%-7s %9s %10s %9s %9s %9s %9s\n' -e solve_s bytes mesh_rel mesh_s pixel_rel pixel_s
  for error in $errors; do
    solve=$(cpu "$work/$error.strad" strad-solve -q -e "$error" "$work/scene.strad")
    mesh=$(render "$work/mesh_%04d.pfm" "$size" "$frames" "$work/$error.strad" --direct mesh)
    pixel=$(render "$work/pixel_%04d.pfm" "$size" "$frames" "$work/$error.strad")
    rel_mesh=$(rel "$scene" "$work/mesh_%04d.pfm" "$frames")
    rel_pixel=$(rel "$scene" "$work/pixel_%04d.pfm" "$frames")
    printf '%-7s %9s %10s %9s %9s %9s %9s\n' "$error" "$solve" "$(stat -c %s "$work/$error.strad")" "$rel_mesh" \
      "$mesh" "$rel_pixel" "$pixel"
    echo "$solve $rel_mesh" >>"$work/spacetime"
  done
}

mean() { awk '{ sum += $1 } END { printf "%.3f\n", sum / NR }'; }

# Frame by frame through the same code, at the truth's instants, and the ratio at equal error by interpolation
# (in logarithms) of its curve of CPU seconds over error.
acceleration() {
  local scene=$1 frames size error total
  frames=$(truth_frames "$scene")
  size=$(truth_size "$scene")
  total=$(fact frames)
  echo "# frame by frame: mean CPU s of an instant, and its error from the mesh in percent"
  printf '%-7s %9s %9s\n' -e instant_s mesh_rel
  for error in $errors; do
    one_by_one "$scene" "$error" "$frames" "$size"
  done | tee "$work/instants"
  echo "# acceleration over frame by frame at equal error, $total frames"
  printf '%9s %9s %9s\n' mesh_rel solve_s times
  awk -v total="$total" -f "$here/acceleration.awk" "$work/instants" "$work/spacetime"
}

one_by_one() {
  local scene=$1 error=$2 frames=$3 size=$4 frame seconds
  seconds=$(for frame in ${frames//,/ }; do
    cpu "$work/at_$frame.strad" strad-solve -q -e "$error" --at "$(frame_time "$frame")" "$work/scene.strad"
  done | mean)
  for frame in ${frames//,/ }; do
    strad-frame -q --direct mesh -s "$size" -t "$(frame_time "$frame")" \
      -o "$work/at_$(printf %04d "$frame").pfm" "$work/at_$frame.strad"
  done
  printf '%-7s %9s %9s\n' "$error" "$seconds" "$(rel "$scene" "$work/at_%04d.pfm" "$frames")"
}

frame_time() {
  awk -v start="$(fact 'start s')" -v rate="$(fact 'rate 1/s')" -v frame="$1" \
    'BEGIN { printf "%.9g\n", start + (frame - 1) / rate }'
}

error_against_itself() {
  local error finest
  finest=$(awk -v list="$errors" 'BEGIN { n = split(list, e, " "); print e[n] / 4 }')
  strad-solve -q -e "$finest" "$work/scene.strad" >"$work/finest.strad"
  echo "# error against a solution with -e $finest, in percent; CPU s of the solve"
  printf '%-7s %9s %10s %9s\n' -e solve_s bytes rel
  for error in $errors; do
    local solve rel
    solve=$(cpu "$work/$error.strad" strad-solve -q -e "$error" "$work/scene.strad")
    rel=$(strad-diff "$work/finest.strad" "$work/$error.strad" --rel-rmse 1e9 | value rel_rmse)
    printf '%-7s %9s %10s %9s\n' "$error" "$solve" "$(stat -c %s "$work/$error.strad")" \
      "$(awk -v rel="$rel" 'BEGIN { printf "%.2f", 100 * rel }')"
  done
}

# jumps STREAM: in percent of the mean radiance at 1/4, 1/2 and 3/4 of the time, as solved; then as frames show it.
jumps() {
  local part start end
  start=$(fact 'start s')
  end=$(fact 'end s')
  for part in 1 2 3; do
    strad-diff --jump "$(awk -v a="$start" -v b="$end" -v part=$part 'BEGIN { printf "%.9g", a + (b - a) * part / 4 }')" "$1"
  done | awk '{ value[$1] = value[$1] sprintf(" %9.4f", 100 * $2) } END { print value["jump"] value["jump_continuous"] }'
}

continuity() {
  local basis
  echo "# jump in percent of the mean radiance at 1/4, 1/2 and 3/4 of the time: as solved, and as frames show it"
  printf '%-7s %9s %9s %9s %9s %9s %9s\n' basis 1/4 1/2 3/4 1/4 1/2 3/4
  for basis in m1 m2 m3; do
    strad-solve -q --basis $basis "$work/scene.strad" >"$work/basis.strad"
    printf '%-7s%s\n' $basis "$(jumps "$work/basis.strad")"
  done
}
