# What tests/bench/bench.sh measures; it sets `here`, `work` and `errors`.

TIMEFORMAT='%U %S'

# cpu OUTPUT COMMAND...: runs it with standard output to OUTPUT and prints its CPU seconds.
cpu() {
  local output=$1
  shift
  { time "$@" >"$output" 2>"$work/log" || { cat "$work/log" >&2; exit 1; }; } 2>&1 | awk '{ printf "%.3f\n", $1 + $2 }'
}

# value NAME <TEXT: the value on the line `NAME value`.
value() { awk -v name="$1" '$1 == name { print $2 }'; }

source_of() {
  local folder=$here/../../scenes/$1
  strad-import "$folder/$1.obj" | strad-motion "$folder/$1.motion"
}

frame_total() { strad-info --json "$work/scene.strad" | tr ',{}' '\n\n\n' | awk -F: '$1 ~ /"frames"/ { print $2 + 0 }'; }

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

error_against_truth() {
  local scene=$1 frames size count error solve mesh pixel rel_mesh rel_pixel
  frames=$(truth_frames "$scene")
  count=$(tr ',' '\n' <<<"$frames" | wc -l)
  size=$(truth_size "$scene")
  echo "# error against the truth in percent, direct light from the mesh and per pixel; CPU s of the solve and of one frame"
  printf '%-7s %9s %10s %9s %9s %9s %9s\n' -e solve_s bytes mesh_rel mesh_s pixel_rel pixel_s
  for error in $errors; do
    solve=$(cpu "$work/$error.strad" strad-solve -q -e "$error" "$work/scene.strad")
    mesh=$(cpu /dev/null strad-frame -q --direct mesh -s "$size" -f "$frames" -o "$work/mesh_%04d.exr" "$work/$error.strad")
    pixel=$(cpu /dev/null strad-frame -q -s "$size" -f "$frames" -o "$work/pixel_%04d.exr" "$work/$error.strad")
    rel_mesh=$(rel "$scene" "$work/mesh_%04d.exr" "$frames")
    rel_pixel=$(rel "$scene" "$work/pixel_%04d.exr" "$frames")
    printf '%-7s %9s %10s %9s %9s %9s %9s\n' "$error" "$solve" "$(stat -c %s "$work/$error.strad")" "$rel_mesh" \
      "$(per "$mesh" "$count")" "$rel_pixel" "$(per "$pixel" "$count")"
    echo "$solve $rel_mesh" >>"$work/spacetime"
  done
}

per() { awk -v total="$1" -v count="$2" 'BEGIN { printf "%.3f\n", total / count }'; }

# Frame by frame through the same code, at the truth's instants, and the ratio at equal error by interpolation
# (in logarithms) of its curve of CPU seconds over error.
acceleration() {
  local scene=$1 frames size error total
  frames=$(truth_frames "$scene")
  size=$(truth_size "$scene")
  total=$(frame_total)
  echo "# frame by frame: mean CPU s of an instant, and its error from the mesh in percent"
  printf '%-7s %9s %9s\n' -e instant_s mesh_rel
  for error in $errors; do
    one_by_one "$scene" "$error" "$frames" "$size"
  done | tee "$work/instants"
  echo "# acceleration over frame by frame at equal error, $total frames"
  printf '%9s %9s %9s\n' mesh_rel solve_s times
  awk -v total="$total" -f "$here/acceleration.awk" "$work/instants" "$work/spacetime"
  rm -f "$work/spacetime"
}

one_by_one() {
  local scene=$1 error=$2 frame sum=0 count=0 time
  for frame in ${3//,/ }; do
    time=$(strad-info "$work/scene.strad" >/dev/null && frame_time "$frame")
    sum=$(awk -v a="$sum" -v b="$(cpu "$work/at.strad" strad-solve -q -e "$error" --at "$time" "$work/scene.strad")" \
      'BEGIN { print a + b }')
    strad-frame -q --direct mesh -s "$4" -t "$time" -o "$work/at_$(printf %04d "$frame").exr" "$work/at.strad"
    count=$((count + 1))
  done
  printf '%-7s %9s %9s\n' "$error" "$(per "$sum" "$count")" "$(rel "$scene" "$work/at_%04d.exr" "$3")"
}

json_number() { strad-info --json "$work/scene.strad" | tr ',{}' '\n\n\n' | awk -F: -v key="\"$1\"" '$1 ~ key { print $2 + 0; exit }'; }
frame_time() {
  awk -v start="$(json_number start)" -v rate="$(json_number rate)" -v frame="$1" \
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

continuity() {
  local basis part start end time
  start=$(json_number start)
  end=$(json_number end)
  echo "# jump in percent of the mean radiance at 1/4, 1/2 and 3/4 of the time: as solved, and as frames show it"
  printf '%-7s %9s %9s %9s %9s %9s %9s\n' basis 1/4 1/2 3/4 1/4 1/2 3/4
  for basis in m1 m2 m3; do
    strad-solve -q --basis $basis "$work/scene.strad" >"$work/basis.strad"
    for part in 1 2 3; do
      time=$(awk -v a="$start" -v b="$end" -v part=$part 'BEGIN { printf "%.9g", a + (b - a) * part / 4 }')
      strad-diff --jump "$time" "$work/basis.strad"
    done | awk -v basis=$basis '{ value[$1] = value[$1] sprintf(" %9.4f", 100 * $2) }
      END { printf "%-7s%s%s\n", basis, value["jump"], value["jump_continuous"] }'
  done
}
