# The hard scenes compile: closed bodies with the right number of polygons, and what moves is found. In the one with two
# doors, light arrives in the last room: on its floor, and on the front of each shelf.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
trials=$STRAD_SOURCE_DIR/scenes/trials/trials.sh

status=0
"$trials" nothing out 2>err || status=$?
[ $status = 2 ]
[ "$(wc -l <err)" = 1 ]
[ ! -e out ]

# A room is 6 polygons, a lamp 6, a closed box 6, an open one 5, a table 26, the statue 50 rings of 100. The world, each
# body and the camera have keys.
while read -r name polygons bodies; do
  "$trials" "$name" "$name"
  strad-import -q "$name/$name.obj" | strad-motion -q "$name/$name.motion" >"$name.strad"
  strad-info "$name.strad" >info
  grep -q "^  polygons: $polygons$" info
  [ "$(grep -c 'keys' info)" = "$bodies" ]
done <<'END'
doors 332 3
belt 334 8
beams 342 3
fan 92 3
statue 5060 3
slit 29 3
END

strad-solve -q -e 1 --at 4 -o solved.strad doors.strad
strad-probe -q -n 1 --at 7.5,2,0,0,0,1 --at 8.66,2,0.415,-1,0,0 --at 8.66,2,1.615,-1,0,0 solved.strad >light
[ "$(awk '$3 != "object" && $4 > 0 && $5 > 0 && $6 > 0' light | wc -l)" = 3 ]
