# scenes/orrery as a binary glTF file: nodes that move are bodies with their parents, and the whole pipeline runs on it.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
"$STRAD_SOURCE_DIR/scenes/orrery/orrery.sh" orrery.glb

strad-import -q orrery.glb >orrery.strad
strad-motion --print orrery.strad >motion
fail() { echo "$1"; cut -c1-120 motion; exit 1; }
block() { sed -n "/^$1\$/,/^\$/p" motion; }
# 4 s of keys and one frame more.
grep -qx 'time 0 4.04' motion || fail time
# The arm's quaternions are 90 degrees apart: two keys would be 270 degrees apart, of which the shorter way is another.
block 'body arm' >arm
[ "$(grep -c key arm)" -ge 3 ] || fail 'keys of the arm'
grep -qx '  parts beam' arm || fail 'parts of the arm'
# The planet rides on the arm, its moon's axis and the spotlight on the planet.
block 'body planet' | grep -x '  on arm' >/dev/null || fail planet
block 'body "moon axis"' | grep -qx '  on planet' || fail moon
block 'spot torch' >torch
grep -qx '  on planet' torch || fail torch
# 3415 cd of colour 1, 0.9, 0.7 at 683 lm/W: 5 W/sr.
grep -q 'intensity 5 4.5 3.5$' torch || fail intensity
strad-import -q --lumens-per-watt 3415 orrery.glb | strad-motion --print | grep 'intensity 1 0.9 0.7$' >/dev/null || fail 'lumens per watt'
# The planet is up by 0.4 m at 2 s.
block 'body planet' | awk '$1 == "key" && $2 == 2 { k = ($5 - 0.4) ^ 2 < 1e-12 } END { exit !k }' || fail 'way of the planet'
# The flag jumps: a step at 2 s.
block 'body flag' >flag
grep -qx '  key 2  move 0 0 0' flag && grep -qx '  key 2  move 0 1 0' flag || fail flag
# The camera has no body, but two keys.
[ "$(sed -n '/^camera main/,$p' motion | grep -c key)" = 2 ] || fail camera
strad-motion motion orrery.strad | cmp - orrery.strad
strad-solve -q -e 0.5 --at 1 orrery.strad | strad-frame -t 1 -s 16x12 >a.ppm

# The same by its name, at another rate.
strad-import -q --animation run --rate 50 orrery.glb | strad-motion --print | grep -x 'time 0 4.02' >/dev/null || fail rate

refused() {  # refused EXPECTED-TEXT ARGUMENTS...
  local status=0 expected=$1
  shift
  strad-import "$@" >out 2>err || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF -e "$expected" err || [ -s out ]; then
    echo "strad-import $*: exit status $status, expected 2 and: $expected"
    cat err
    exit 1
  fi
}
refused "--animation: found 'walk', expected one of run" --animation walk orrery.glb
refused '--frames' -f 1:3 orrery.glb
refused '--lumens-per-watt' --lumens-per-watt 0 orrery.glb
refused 'absent.glb' absent.glb
head -c 900 orrery.glb >cut.glb
refused 'cut.glb: ' cut.glb
printf 'v 0 0 0\n' >obj.gltf
refused 'obj.gltf: ' obj.gltf
