# With -v each tool says on standard error what it does; with -q, and -q -v, it says nothing.
scene=$STRAD_SOURCE_DIR/scenes/lamp/lamp
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

says() {  # says PATTERN TOOL...: each line begins with the tool's name, one matches, and -q silences it
  local pattern=$1
  shift
  "$@" -v >out 2>err
  grep -qE "^$1: $pattern" err || { echo "$* -v: found '$(cat err)', expected '$pattern'"; exit 1; }
  if grep -v "^$1: " err; then exit 1; fi
  "$@" -q -v >quiet_out 2>err
  test ! -s err
  if [ "$1" = strad-diff ]; then : >out; fi # which with -q tells by its exit status alone
  cmp out quiet_out
}
says '.*[0-9]+ polygons, .*materials' strad-import $scene.obj -o scene
says '.*2 bodies, .*1 cameras, [0-9]+ frames' strad-motion $scene.motion scene -o moving
says 'direct light: [0-9.]+ s$' strad-solve -e 0.5 --time 0:2 moving -o solved
strad-solve -v -e 0.5 --time 0:2 moving -o solved 2>phases
[ "$(sed -E 's/^strad-solve: (.*): [0-9.]+ s$/\1/' phases | tr '\n' ',')" = 'preparation,direct light,links,bounces,final gather,' ]
says 'frame 3: [0-9.]+ s$' strad-frame -f 1:3 -s 16x12 solved
says 'frame 3: [0-9.]+ s$' strad-frame -f 1:3 -s 16x12 --reference 1 solved
says 'frame 3: [0-9.]+ s$' strad-frame -f 1:3 -s 16x12 --show elements solved
says 'frame 3: [0-9.]+ s$' strad-frame -f 3 --ply solved
says 'frame 3: [0-9.]+ s$' strad-frame -f 1:3 --ply -o ply.%d.ply solved
says 'frame 3: [0-9.]+ s$' strad-frame -f 1:3 --pov -o pov.%d.inc solved
says 'point 0: .* 0\.[0-9]+ m from the position asked for, on ' strad-probe --at 1,0.1,1 -n 2 solved
says '[0-9]+ points count$' strad-check --points 50 --paths 16 solved
says 'solved: [0-9]+ polygons.* 1 solved slabs' strad-info solved
says 'joined 1 streams' strad-join solved
says 'solved: [0-9]+ polygons' strad-diff solved solved
strad-frame -q -f 1:2 -s 16x12 -o 'f.%d.ppm' solved
says 'f\.2\.ppm: rel_rmse 0, bias 0, max 0' strad-diff f.%d.ppm f.%d.ppm

# No tool whose manual page has -v is left out above.
for page in "$STRAD_SOURCE_DIR"/man/strad-*.1; do
  tool=$(basename "$page" .1)
  if grep -q 'Fl -verbose' "$page"; then
    grep -qE "^says .* $tool( |$)" "$STRAD_SOURCE_DIR/tests/pipelines/verbose_says_what_tools_do.sh" ||
      { echo "$tool -v is not tested"; exit 1; }
  fi
done
