# scenes/windmill as numbered OBJ files, with six decimals: rigid motions come back as bodies with few keys, at their own
# pivots; what is no rigid motion, or another topology, is refused.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
"$STRAD_SOURCE_DIR/scenes/windmill/windmill.sh" 76 .

strad-import -q -f 1:76 --rate 25 'windmill.%04d.obj' >windmill.strad
strad-motion --print windmill.strad >motion
fail() { echo "$1"; cat motion; exit 1; }
grep -qx 'time 0 3.04' motion || fail time
[ "$(grep -c '^body' motion)" = 2 ] || fail bodies
# Hub and blades are one body. It turns by 90 degrees a second about (0, 2), counter-clockwise seen from +z: 270 degrees at
# 3 s, in two keys. Coordinates are off by up to 5e-7, of an arm of 1.3 m.
sed -n '/^body hub$/,/^$/p' motion >hub
grep -qx '  parts hub blade0 blade1 blade2 blade3' hub || fail hub
[ "$(grep -c key hub)" = 2 ] || fail 'keys of the hub'
awk '$1 == "pivot" { p = $2 ^ 2 + ($3 - 2) ^ 2 < 1e-10 }
     $1 == "axis" { a = $2 ^ 2 + $3 ^ 2 < 1e-10 && $4 > 0.999999 }
     $1 == "key" && $2 == 3 { k = ($NF - 270) ^ 2 < 1e-8 }
     END { exit !(p && a && k) }' hub || fail 'motion of the hub'
# The boat goes 1.5 m in 2 s, then rests.
sed -n '/^body boat$/,/^$/p' motion >boat
[ "$(grep -c key boat)" = 2 ] || fail 'keys of the boat'
awk '$1 == "key" && $2 == 2 { k = ($4 - 1.5) ^ 2 + $5 ^ 2 + $6 ^ 2 < 1e-11 } END { exit !k }' boat || fail 'motion of the boat'
strad-motion motion windmill.strad | cmp - windmill.strad

# Every fifth file is a frame of its own: 16 frames, of 1/5 s at 5 a second.
strad-import -q -f 1:76:5 --rate 5 'windmill.%04d.obj' | strad-motion --print >motion
grep -qx 'time 0 3.2' motion || fail 'time of a list'

# One that is lit and looked at.
strad-solve -q -e 0.5 --at 1 windmill.strad | strad-frame -t 1 -s 16x12 --camera-at 'from 2 2 2.9 to 0 1.8 0' >a.ppm
[ "$(wc -c <a.ppm)" -gt 500 ]

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
refused 'windmill.0077.obj' -f 70:77 'windmill.%04d.obj'
refused 'expected a number in it' -f 1:3 windmill.0001.obj
refused '--rate' --rate 25 windmill.0001.obj
refused '--clock' --clock 0:1 -f 1:3 'windmill.%04d.obj'
refused "--frames: found '3:1'" -f 3:1 'windmill.%04d.obj'
# A blade grows by a tenth of a millimetre: it is an error, or stays as it was.
cp windmill.0003.obj bent.0003.obj
cp windmill.0001.obj bent.0001.obj
awk '/^o blade2/ { b = 1 } /^o boat/ { b = 0 } b && /^v/ && ++n == 1 { $2 += 0.0001 } { print }' windmill.0002.obj >bent.0002.obj
refused 'bent.0001.obj:' -f 1:3 'bent.%04d.obj'
refused 'the object "blade2" changes its shape in bent.0002.obj' -f 1:3 'bent.%04d.obj'
strad-import --skip-unknown -f 1:3 'bent.%04d.obj' 2>err | strad-motion --print >motion
grep -q 'the object "blade2" changes its shape in bent.0002.obj: kept as it is in bent.0001.obj' err
grep -q 'parts hub blade0 blade1 blade3$' motion || fail 'without blade2'
# Other numbers of things, other faces.
sed '0,/^f /s//#f /' windmill.0002.obj >bent.0002.obj
refused 'bent.0002.obj: has 47 faces, expected 48 as in bent.0001.obj' -f 1:2 'bent.%04d.obj'
sed 's/^o boat/o ship/' windmill.0002.obj >bent.0002.obj
refused 'bent.0002.obj: its objects are not those of bent.0001.obj' -f 1:2 'bent.%04d.obj'
sed '0,/^f -4 -3 -2 -1/s//f -3 -2 -1 -4/' windmill.0002.obj >bent.0002.obj
refused 'bent.0002.obj:8: the face is not the same as in bent.0001.obj' -f 1:2 'bent.%04d.obj'
