# What is accepted but can hardly be meant gets a note, and what is refused says what is wrong with it.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/shutter/shutter
strad-import $scene.obj 2>/dev/null >rest.strad
strad-motion $scene.motion rest.strad >scene.strad
strad-solve -e 0.5 scene.strad 2>err >solved.strad
test ! -s err

# told NOTE COMMAND...: succeeds with exactly this note, and with none under -q.
told() {
  "${@:2}" 2>err >out
  grep -q "^[a-z-]*: $1\$" err && test "$(wc -l <err)" = 1 || { echo "${*:2}:"; cat err; exit 1; }
  "${@:2}" -q 2>err >out
  test ! -s err
}
# refused FAULT COMMAND...: exit status 2 and this line.
refused() {
  local status=0
  "${@:2}" 2>err >out || status=$?
  test $status = 2 && grep -q "^[a-z-]*: $1" err && test "$(wc -l <err)" = 1 || { echo "${*:2}:"; cat err; exit 1; }
  test ! -s out
}

# A point that no surface is near; one in the middle of the room is usual.
told 'point 0: .* m from the position asked for, on .*' strad-probe -n 1 --at 0,1000,0 solved.strad
strad-probe -n 1 --at 0,0.1,0 solved.strad 2>err >out
test ! -s err

printf 'newmtl grey\nKd 0.5 0.5 0.5\n' >m.mtl
printf 'mtllib m.mtl\nusemtl grey\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >dark.obj
strad-import dark.obj >dark.strad
told 'the scene has no light: no polygon emits, and there is no spotlight' strad-solve dark.strad
printf 'time 0 1\nglow grey\n  key 0 value 1\n  key 1 value 2\n' >glow.motion
printf 'newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKe 1 1 1\n' >m.mtl
printf 'mtllib m.mtl\nusemtl grey\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nusemtl lamp\nf 1 2 4\n' >lit.obj
strad-import lit.obj >lit.strad
told 'glow "grey": the material emits nothing, and stays dark' strad-motion glow.motion lit.strad

refused "--rel-rmse: found '1%', expected a plain number: 0.01" strad-diff --rel-rmse 1% solved.strad solved.strad
refused "-e,--error: found '2%', expected a plain number: 0.02" strad-solve -e 2% scene.strad
refused "the slab's end: found 1000.000000 s, expected a time in the animation" strad-solve --time 0:1000 scene.strad
refused '--time: found 1000 s, but the solution holds' strad-frame --time 1000 solved.strad
refused 'found the unknown option --erorr, did you mean --error?; see strad-solve --help' strad-solve --erorr 0.1 scene.strad
refused 'found the unknown option --sampels, did you mean --samples?' strad-frame solved.strad --sampels=4
refused 'found the unknown option --xyzzy; see' strad-info --xyzzy solved.strad
refused "found 'two', expected no more file names" strad-info solved.strad two
