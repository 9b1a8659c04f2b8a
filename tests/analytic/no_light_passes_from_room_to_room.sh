# Two rooms share one wall without thickness; a bright light sweeps the east room, a dim one stands in the west room.
# What the west room has with the bright light on is, to a 300th of the east room's light, what it has without:
# nothing comes through the wall, under it or round its edges. So is what it has with the bright light alone: nothing.
source "$STRAD_SOURCE_DIR/tests/analytic/hall.bash"
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

begin_hall rooms >rooms.obj
cat >>rooms.obj <<'END'
v 1.37 0 0
v 1.37 3 0
v 1.37 3 2.5
v 1.37 0 2.5
o floors
f 1 9 10 4
f 9 2 3 10
o ceilings
f 5 8 11 12
f 12 11 7 6
o south
f 1 5 12 9
f 9 12 6 2
o north
f 3 7 11 10
f 10 11 8 4
o east
f 2 6 7 3
o west
f 4 8 5 1
o wall
f 9 10 11 12
END
echo 'time 0 2' >time
cat >bright <<'END'
spot bright
  cone 30 40
  key 0 at 3.8 1.5 2.3 aim 2 0.5 0 intensity 20 20 20
  key 2 at 3.8 1.5 2.3 aim 2 2.5 0 intensity 20 20 20
END
cat >dim <<'END'
spot dim
  cone 30 40
  key 0 at 0.2 1.5 2.3 aim 0.7 1.5 0 intensity 0.2 0.2 0.2
END
cat >points <<'END'
2.6 1.5 0
1.3 0.7 0
0.8 0.7 0
0.4 1.9 2.5
1.2 0 1.1
0 1.5 1.2
1.37 1.5 1.2 -1 0 0
END
strad-import rooms.obj >rooms.strad
for lights in 'bright dim' dim bright; do
  cat time $lights >rooms.motion
  strad-motion rooms.motion rooms.strad | strad-solve >"$lights.strad"
  for direct in pixel mesh; do
    strad-probe -n 5 --direct $direct --points points "$lights.strad" >"$lights $direct"
  done
done

for direct in pixel mesh; do
  paste "bright dim $direct" "dim $direct" "bright $direct" | awk -v direct=$direct '
    function leak(where, light) {
      if (light < 0) light = -light
      if (!(light <= worst[where])) { worst[where] = light; at[where] = $0 }
    }
    NR == 1 { next }
    $2 == 0 { light += $7 / 5; next }
    {
      leak(direct " beside the dim light", $7 - $16)
      leak(direct " in the dark", $25)
      points++
    }
    END {
      if (points != 30 || !(light > 2)) { print "points missed"; exit 1 }
      for (where in worst) {
        printf "%s: %g of %g W/m^2\n", where, worst[where], light
        if (!(worst[where] < light / 300)) { print "  " at[where]; failed = 1 }
      }
      exit failed
    }'
done
