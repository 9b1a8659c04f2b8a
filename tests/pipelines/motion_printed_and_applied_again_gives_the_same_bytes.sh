# strad-motion --print of every scene, applied to the scene's own stream unchanged, gives that stream to the byte; applied
# to the scene at rest, it gives the motion that the scene's own motion file gives, to the bit of every number.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

"$STRAD_SOURCE_DIR/scenes/halls/halls.sh" 2000 halls
cp -r "$STRAD_SOURCE_DIR"/scenes/*/ .
count=0
for obj in */*.obj; do
  scene=${obj%.obj}
  strad-import -q "$obj" >rest.strad
  strad-motion "$scene.motion" rest.strad >moving.strad
  strad-motion --print moving.strad >printed.motion
  strad-motion printed.motion moving.strad | cmp - moving.strad || { echo "$scene: changed"; exit 1; }
  strad-motion printed.motion rest.strad | strad-motion --print | cmp - printed.motion || { echo "$scene: differs"; exit 1; }
  count=$((count + 1))
done
[ $count -ge 10 ] || { echo "only $count scenes"; exit 1; }

# Of a solved stream, the solution stays: also where only cameras and the rate change.
strad-import -q swing/swing.obj | strad-motion swing/swing.motion | strad-solve -q -e 0.5 >solved.strad
strad-motion --print solved.strad | strad-motion - solved.strad | cmp - solved.strad
printf 'rate 24000/1001\ncamera above\n  key 0 from 0 9 0.1 to 0 0 0\n' >look.motion
strad-motion look.motion solved.strad >look.strad 2>note
grep -q dropped note && exit 1
strad-frame -f 1 -c above -s 8x8 look.strad >/dev/null
strad-motion --print look.strad >printed.motion
grep -qx 'rate 24000/1001' printed.motion
strad-diff look.strad solved.strad >/dev/null

refused() {  # refused EXPECTED-TEXT ARGUMENTS...
  local status=0 expected=$1
  shift
  strad-motion "$@" </dev/null >out 2>err || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF -e "$expected" err || [ -s out ]; then
    echo "strad-motion $*: exit status $status, expected 2 and: $expected"
    cat err
    exit 1
  fi
}
refused '--print: found two names' --print look.motion solved.strad
refused 'absent.strad' --print absent.strad
refused 'expected MOTION and STREAM'
