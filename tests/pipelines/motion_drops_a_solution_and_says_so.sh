# A solution belongs to the motion it was made with: new motion drops it, with one note, or none with -q.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/swing/swing

strad-import $scene.obj | strad-motion $scene.motion >scene.strad
strad-solve -q -e 0.3 scene.strad >solved.strad
echo 'rate 10' >slow.motion
strad-motion slow.motion solved.strad >slow.strad 2>note
[ "$(wc -l <note)" = 1 ]
grep -q '^strad-motion: .*solution' note
strad-motion -q slow.motion solved.strad >slow.strad 2>note
[ ! -s note ]
strad-info slow.strad | sed -n '/^scene:/,/^bytes:/p' >info
strad-motion slow.motion scene.strad | strad-info | sed -n '/^scene:/,/^bytes:/p' | cmp info

strad-probe --at 0,0,0 -n 2 solved.strad >/dev/null
if strad-probe --at 0,0,0 -n 2 slow.strad >/dev/null 2>note; then
  echo "the solution is still there"
  exit 1
fi
