# A scene written for POV-Ray and read back is the same scene: solved again, its picture is the same.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

cat > room.mtl << 'EOF'
newmtl white
Kd 0.7 0.6 0.5
newmtl red
Kd 0.6 0.1 0.1
newmtl lamp
Kd 0.3 0.3 0.3
Ke 6 6 6
EOF
cat > room.obj << 'EOF'
mtllib room.mtl
v -2 0 2
v 2 0 2
v 2 0 -2
v -2 0 -2
v -2 3 -2
v 2 3 -2
v -0.5 2.5 0.5
v -0.5 2.5 -0.5
v 0.5 2.5 -0.5
v 0.5 2.5 0.5
v 0.5 0.2 0
v 1.3 0.2 0
v 1.3 1.2 -0.4
v 0.5 1.2 -0.4
o floor
usemtl white
f 1 2 3 4
o wall
usemtl red
f 4 3 6 5
o lamp
usemtl lamp
f 7 8 9 10
o board
usemtl white
f 11 12 13 14
EOF
cat > room.motion << 'EOF'
time 0 1
rate 4
body board
  parts board
  pivot 1 0 0
  key 0 move 0 0 0 turn 0
  key 1 move -0.5 0 0.3 turn 40
spot beam
  cone 15 25
  key 0 at -1.5 2 1.5 aim 0 0.3 -1 intensity 9 8 6
camera main
  key 0 from 0.5 1.4 5 to 0 1 0 up 0 1 0 fov 45
EOF

strad-import room.obj | strad-motion room.motion | strad-solve -q -e 0.1 -o first.strad
strad-frame -q -f 3 --pov --direct pixel -o pov.%04d.inc first.strad
# The light that was baked in goes, the lamp's own comes back. Names follow the pigments of the export.
strad-import -q --light '*=0,0,0' --light 'strad_pigment_lamp=6,6,6' -o back.strad pov.pov
strad-solve -q -e 0.1 -o second.strad back.strad
strad-frame -q -f 3 -s 96x72 -o first.exr first.strad
strad-frame -q -f 1 -s 96x72 -o second.exr second.strad
# Two solves of different meshes differ by their tolerance; a wrong light, pose or colour differs by far more.
strad-diff --rel-rmse 0.03 first.exr second.exr
