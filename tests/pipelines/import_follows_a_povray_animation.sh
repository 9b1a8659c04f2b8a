# strad-import of scenes/crane: what moves in POV-Ray's language moves in the stream, as the arithmetic of the .pov says, in
# few keys, and the whole pipeline runs on it.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
cp "$STRAD_SOURCE_DIR"/scenes/crane/crane.* .

strad-import -q crane.ini >crane.strad
strad-motion --print crane.strad >crane.motion
fail() { echo "$1"; cat crane.motion; exit 1; }

# 101 frames at 25 a second.
grep -qx 'time 0 4.04' crane.motion || fail 'time'
# The arm turns by 200 degrees about its foot, at (-1, 0, 0.5). z is mirrored, so the foot is at z = -0.5 and the turn goes
# the other way: POV-Ray's rotate y * 90 takes x to -z, which becomes z, and in the stream 90 degrees about y take x to -z.
block() { sed -n "/^$1\$/,/^\$/p" crane.motion; }
block 'body Arm' >arm
grep -qx '  key 0  turn 0' arm || fail 'arm'
grep -qx '  key 4  turn -200' arm || fail 'arm'
[ "$(grep -c key arm)" = 2 ] || fail 'keys of the arm'
awk '$1 == "pivot" { ok = ($2 + 1) ^ 2 + ($4 + 0.5) ^ 2 < 1e-20 } END { exit !ok }' arm || fail 'pivot of the arm'
# The cart: to 3 m at clock 0.6, 2.4 s, then back by half; it carries its headlight, which has one key.
block 'body union' >cart
[ "$(grep -c key cart)" = 3 ] || fail 'keys of the cart'
grep -qx '  key 2.4  move 3 0 0' cart || fail 'cart'
grep -qx '  key 4  move 1.5 0 0' cart || fail 'cart'
block 'spot Headlight' >headlight
grep -qx '  on union' headlight || fail 'headlight'
[ "$(grep -c key headlight)" = 1 ] || fail 'keys of the headlight'
# The wheels roll: those of one axle alike, so there are two bodies with three keys. 3 m / 0.2 m = 15 radians, clockwise seen
# from the camera's side, where z is larger.
[ "$(grep -c '^body Wheel' crane.motion)" = 2 ] || fail 'wheels'
block 'body Wheel' >wheel
[ "$(grep -c key wheel)" = 3 ] || fail 'keys of a wheel'
awk '$1 == "key" && $2 == 2.4 { ok = ($8 * 3.14159265358979 / 180 + 15) ^ 2 < 1e-20 } END { exit !ok }' wheel || fail 'wheel'
awk '$1 == "pivot" { ok = ($2 + 2.5) ^ 2 + ($3 - 0.2) ^ 2 < 1e-20 } END { exit !ok }' wheel || fail 'axle'
# The lamp dims to a fifth.
grep -A2 '^glow' crane.motion | grep -qx '  key 4  value 0.2' || fail 'lamp'
[ "$(grep -A9 '^glow' crane.motion | sed '/^$/,$d' | grep -c key)" = 2 ] || fail 'keys of the lamp'
# The camera moves along a line and looks at a point.
[ "$(sed -n '/^camera/,$p' crane.motion | grep -c key)" = 2 ] || fail 'keys of the camera'
# The foot and the room rest.
strad-info --objects crane.strad | grep 'name Foot, body world,' >/dev/null || fail 'foot'

# Printed and applied again it is the same; a still of any frame is that frame of the animation.
strad-motion crane.motion crane.strad | cmp - crane.strad
strad-solve -q -e 0.5 --at 2 crane.strad | strad-frame -t 2 -s 40x30 --direct pixel --pfm >moving.pfm
strad-import -q --clock 0.5 crane.pov | strad-solve -q -e 0.5 | strad-frame -s 40x30 --direct pixel --pfm >still.pfm
strad-diff moving.pfm still.pfm --rel-rmse 0.15 >/dev/null || { strad-diff moving.pfm still.pfm; exit 1; }
