# Inside a closed box no light arrives at any time: neither in one that stands in a lit room nor in one that moves and
# turns under a spotlight, passing through it. Their outsides are lit.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

cat >room.mtl <<'END'
newmtl white
Kd 0.7 0.7 0.7
newmtl lamp
Kd 0 0 0
Ke 10 10 10
END
# box NAME X Y Z SIZE [inwards]: corners by 3 bits, faces outwards or inwards.
box() {
  awk -v name="$1" -v x="$2" -v y="$3" -v z="$4" -v sx="$5" -v sy="$6" -v sz="$7" -v inwards="${8:-}" 'BEGIN {
    print "o " name
    for (i = 0; i < 8; i++) print "v", x + i % 2 * sx, y + int(i / 2) % 2 * sy, z + int(i / 4) * sz
    n = split("1 3 4 2  5 6 8 7  1 2 6 5  3 7 8 4  1 5 7 3  2 4 8 6", c)
    for (f = 1; f <= n; f += 4)
      if (inwards) print "f", c[f + 3] - 9, c[f + 2] - 9, c[f + 1] - 9, c[f] - 9
      else print "f", c[f] - 9, c[f + 1] - 9, c[f + 2] - 9, c[f + 3] - 9
  }'
}
{
  echo 'mtllib room.mtl'
  echo 'usemtl white'
  box room 0 0 0 4 3 2.5 inwards
  box chest 0.3 1.8 0 0.9 0.8 0.7
  box crate 1.5 0.6 0.4 0.6 0.6 0.6
  echo 'usemtl lamp'
  echo 'o lamp'
  printf 'v %s\n' '3 2 2.45' '3 2.5 2.45' '3.5 2.5 2.45' '3.5 2 2.45'
  echo 'f -4 -3 -2 -1'
} >room.obj
cat >room.motion <<'END'
time 0 4
body crate
  parts crate
  pivot 1.8 0.9 0.7
  axis 1 1 1
  key 0 turn 0
  key 4 move 1 0.9 0.4 turn 300
spot light
  cone 25 35
  key 0 at 0.5 0.5 2.4 aim 2.2 1.4 0.8 intensity 20 20 20
END

# Insides of all six sides of the crate and three of the chest, then as many outsides: normals tell them apart.
cat >inside <<'END'
1.8 0.9 0.4   0 0 1
1.8 0.9 1.0   0 0 -1
1.5 0.9 0.7   1 0 0
2.1 0.8 0.7  -1 0 0
1.8 0.6 0.5   0 1 0
1.7 1.2 0.7   0 -1 0
0.7 2.2 0.7   0 0 -1
0.3 2.2 0.3   1 0 0
0.7 1.8 0.4   0 1 0
END
cat >outside <<'END'
1.8 0.9 0.4   0 0 -1
1.8 0.9 1.0   0 0 1
1.5 0.9 0.7  -1 0 0
0.7 2.2 0.7   0 0 1
0.7 1.8 0.4   0 -1 0
END

strad-import room.obj | strad-motion room.motion | strad-solve -e 0.1 >room.strad
for direct in pixel mesh; do
  strad-probe -n 41 --direct $direct --points inside room.strad >table
  awk -v direct=$direct 'NR > 1 && ($7 != 0 || $8 != 0 || $9 != 0) { bad++; print direct ": light inside: " $0 }
    END { exit NR != 9 * 41 + 1 || bad > 0 }' table
  strad-probe -n 41 --direct $direct --points outside room.strad >table
  awk -v direct=$direct 'NR > 1 { sum[$2] += $7 }
    END { for (p = 0; p < 5; p++) if (!(sum[p] / 41 > 0.2)) { print direct ": no light outside at point " p; exit 1 } }' table
done
