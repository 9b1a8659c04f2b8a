# Two rooms full of small closed boxes, some of which move, 1 cm apart. A spotlight sweeps the east room and its boxes.
# In the west room, and inside of the boxes of both, there is no light at any time: exactly none, whatever surfaces
# are taken together on the way. The outsides of the boxes of the east room are lit.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

cat >rooms.awk <<'END'
function random() { seed = (seed * 16807) % 2147483647; return (seed - 1) / 2147483646 }

BEGIN {
  seed = 5
  print "mtllib rooms.mtl\nusemtl white"
  room("west", 0, 1.99)
  room("east", 2, 4)
}

# 2 m deep and high, fronts inwards; 64 boxes.
function room(name, x0, x1,    x, y, z, i, size, height) {
  begin_object(name)
  sheet(x0 " 0 0 " x1 " 0 0 " x1 " 2 0 " x0 " 2 0"); sheet(x0 " 0 2 " x0 " 2 2 " x1 " 2 2 " x1 " 0 2")
  sheet(x0 " 0 0 " x0 " 0 2 " x1 " 0 2 " x1 " 0 0"); sheet(x1 " 2 0 " x1 " 2 2 " x0 " 2 2 " x0 " 2 0")
  sheet(x1 " 0 0 " x1 " 0 2 " x1 " 2 2 " x1 " 2 0"); sheet(x0 " 2 0 " x0 " 2 2 " x0 " 0 2 " x0 " 0 0")
  dark(name == "west", (x0 + x1) / 2 " 0.03 0"); dark(name == "west", x0 " 1.1 1.3"); dark(name == "west", x1 " 0.9 0.9")
  dark(name == "west", x1 - 0.01 " 1 0"); dark(name == "west", x1 - 0.01 " 1 2")
  for (i = 0; i < 64; ++i) {
    size = 0.12 + 0.16 * random(); height = 0.12 + 0.16 * random()
    x = x0 + 0.25 + 0.5 * (i % 4); y = 0.25 + 0.5 * (int(i / 4) % 4); z = 0.1 + 0.48 * int(i / 16)
    begin_object((i % 3 ? "still_" : "moving_") name i)
    box(x, y, z, size, size, height, random(), 1)
    dark(1, x " " y " " z + height " 0 0 -1"); dark(1, x " " y " " z " 0 0 1")
    dark(name == "west", x " " y " " z + height " 0 0 1"); dark(name == "west", x " " y " " z " 0 0 -1")
  }
}
function dark(yes, point) { print point >(yes ? "dark" : "lit") }
END
printf 'newmtl white\nKd 0.8 0.8 0.8\n' >rooms.mtl
cat >rooms.motion <<'END'
time 0 2
body boxes
  parts moving_*
  key 0 move 0 0 0
  key 2 move 0 0 0.1
spot light
  cone 30 40
  key 0 at 3.9 0.1 1.95 aim 2 0.6 0.2 intensity 20 20 20
  key 2 at 3.9 0.1 1.95 aim 3 1.9 0.2 intensity 20 20 20
END
awk -f "$STRAD_SOURCE_DIR/scenes/halls/solids.awk" -f rooms.awk >rooms.obj

strad-import rooms.obj | strad-motion rooms.motion | strad-solve -e 0.2 >rooms.strad
for direct in pixel mesh; do
  strad-probe -n 9 --direct $direct --points dark rooms.strad >table
  awk -v direct=$direct -v points="$(wc -l <dark)" '
    NR > 1 && ($7 != 0 || $8 != 0 || $9 != 0) { if (++bad <= 5) print direct ": light in the dark: " $0 }
    END { print direct ": " bad + 0 " of " NR - 1 " are not dark"; exit bad > 0 || NR != 9 * points + 1 || points < 389 }' table
  strad-probe -n 9 --direct $direct --points lit rooms.strad >table
  awk -v direct=$direct 'NR > 1 && !($7 > 0.01) { if (++bad <= 5) print direct ": no light: " $0 }
    END { exit bad > 0 || NR != 9 * 133 + 1 }' table
done
