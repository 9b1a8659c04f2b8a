# Floor, ceiling and two walls of a hall are one polygon each; a wall stands across it, as a sheet or 8 cm thick. A lamp
# lights the one part only: the other is dark, to the last bit, right at the foot of the wall, too. A wall that ends
# half way lets light around it, and a floor is not cut under furniture or a sliding door.
source "$STRAD_SOURCE_DIR/tests/analytic/hall.bash"
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

hall="$(begin_hall hall)
o hall
f 1 2 3 4
f 5 8 7 6
f 1 5 6 2
f 3 7 8 4
f 2 6 7 3
f 4 8 5 1
o wall"
sheet() {  # sheet X LENGTH: across the hall
  printf 'v %s 0 0\nv %s %s 0\nv %s %s 2.5\nv %s 0 2.5\n' "$1" "$1" "$2" "$1" "$2" "$1"
}
{ echo "$hall"; sheet 1.37 3; echo 'f 9 10 11 12'; } >thin.obj
{ echo "$hall"; sheet 1.37 3; sheet 1.45 3; echo 'f 9 12 11 10'; echo 'f 13 14 15 16'; } >thick.obj
{ echo "$hall"; sheet 1.37 2; echo 'f 9 10 11 12'; } >half.obj
cat >cupboard.obj <<END
$hall
v 1 1 0
v 1.8 1 0
v 1.8 1.6 0
v 1 1.6 0
v 1 1 1
v 1.8 1 1
v 1.8 1.6 1
v 1 1.6 1
f 9 10 14 13
f 10 11 15 14
f 11 12 16 15
f 12 9 13 16
f 13 14 15 16
END
cat >lamp.motion <<'END'
time 0 2
spot lamp
  cone 30 40
  key 0 at 3.8 1.5 2.3 aim 2 0.5 0 intensity 20 20 20
  key 2 at 3.8 1.5 2.3 aim 2 2.5 0 intensity 20 20 20
END
cat >points <<'END'
2.6 1.5 0
1.36 0.7 0
0.8 0.7 0
0.4 1.9 2.5
1.36 0 1.1
0 1.5 1.2
1.37 1.5 1.2 -1 0 0
END

for scene in thin thick half cupboard; do
  strad-import -q $scene.obj | strad-motion -q lamp.motion | strad-solve -q >$scene.strad
done
{ cat lamp.motion; printf 'body door\n  parts wall\n  key 0 move 0 0 0\n  key 2 move 1 0 0\n'; } >door.motion
strad-import -q half.obj | strad-motion -q door.motion | strad-solve -q -e 0.2 >door.strad
for scene in thin thick half; do
  for direct in pixel mesh; do
    strad-probe -n 5 --direct $direct --points points $scene.strad | awk -v scene="$scene $direct" '
      NR > 1 && $2 == 0 && !($7 > 2) { print scene ": too dark a hall: " $0; failed = 1 }
      NR > 1 && $2 != 0 && (scene ~ /half/ ? !($7 > 0.1) : $7 != 0) { print scene ": " $0; failed = 1 }
      END { exit failed || NR != 36 }'
  done
done

# Two pieces for each of four under the full sheet; three under the half one, which ends in the middle; the cupboard's
# floor is as it was.
polygons() { strad-info --json $1.strad | awk -F'[:,]' '/"polygons"/ { print $2 + 0; exit }'; }
[ "$(polygons thin)" = 11 ]
[ "$(polygons half)" -gt 10 ]
[ "$(polygons cupboard)" = 11 ]
[ "$(polygons door)" = 7 ]
