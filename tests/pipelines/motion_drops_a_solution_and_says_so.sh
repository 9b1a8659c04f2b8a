# A solution belongs to the motion it was made with: motion that changes the light drops it, with one note, or none with -q.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/swing/swing

strad-import $scene.obj | strad-motion $scene.motion >scene.strad
strad-solve -q -e 0.3 scene.strad >solved.strad
echo 'time 0 9' >short.motion
strad-motion short.motion solved.strad >short.strad 2>note
[ "$(grep -vc warning: note)" = 1 ]  # warnings tell of keys after the new end
grep -q '^strad-motion: .*solution' note
strad-motion -q short.motion solved.strad >short.strad 2>note
[ ! -s note ]
strad-info short.strad | sed -n '/^scene:/,/^bytes:/p' >info
strad-motion short.motion scene.strad | strad-info | sed -n '/^scene:/,/^bytes:/p' | cmp info

strad-probe --at 0,0,0 -n 2 solved.strad >/dev/null
if strad-probe --at 0,0,0 -n 2 short.strad >/dev/null 2>note; then
  echo "the solution is still there"
  exit 1
fi

# Each kind of motion that light depends on: where a spotlight is, and which body an object belongs to.
for change in 'spot hanging
  cone 10 20
  key 0 at 0 2 0 aim 0 0 0 intensity 1 1 1' 'body still
  parts *'; do
  echo "$change" | strad-motion - solved.strad 2>note >changed.strad
  grep -q 'solution' note || { echo "kept: $change"; exit 1; }
done
