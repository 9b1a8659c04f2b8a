# Holes of textures let light through, for the solve as for frames: below a black screen with holes, much finer than
# the lamp is wide, a floor has as much of the light as the holes have of the screen; and a solution of a room with a
# screen is as right as any and has the same bytes for any number of threads.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

# Four pixels, one of them opaque.
printf 'P6\n2 2\n255\n\377\377\377\0\0\0\0\0\0\0\0\0' >holes.ppm
cat >screen.mtl <<'EOF'
newmtl floor
Kd 0 0 0
newmtl grey
Kd 0.6 0.6 0.6
newmtl lamp
Kd 0 0 0
Ke 10 10 10
newmtl black
Kd 0 0 0
map_d -s 64 64 holes.ppm
newmtl white
Kd 0.8 0.6 0.4
map_d -s 6 6 holes.ppm
EOF
cat >lamp.obj <<'EOF'
mtllib screen.mtl
v -3 -3 0
v 3 -3 0
v 3 3 0
v -3 3 0
v -1 -1 2
v -1 1 2
v 1 1 2
v 1 -1 2
o floor
usemtl floor
f 1 2 3 4
o lamp
usemtl lamp
f 5 6 7 8
EOF
cp lamp.obj screen.obj
cat >>screen.obj <<'EOF'
v -3 -3 1
v 3 -3 1
v 3 3 1
v -3 3 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
o screen
usemtl black
f 9/1 10/2 11/3 12/4
EOF
seq 0 399 | awk '{ print ($1 % 20 - 9.7) / 20, (int($1 / 20) - 9.7) / 20, 0 }' >points
for name in lamp screen; do
  strad-import -q $name.obj | strad-solve -q >$name.strad
  strad-probe -q --points points -n 1 $name.strad | awk '$1 + 0 == $1 { sum += $(NF - 2) } END { print sum }' >$name.irradiance
done
# By bilinear opacity, the hole of four texels with one opaque is where (1 - x)(1 - y) < 1/2 around it:
# the opaque part of its cell of 2 x 2 texels is 4 times the integral of 1 - 1/(2 (1 - x)) for x of 0 to 1/2,
# which is 4 (1/2 - ln(2)/2) = 0.6137 texels of 4. So 0.8466 of the light comes through.
paste lamp.irradiance screen.irradiance | awk '
  { share = $2 / $1; print "share of light " share; exit !(share > 0.8466 - 0.015 && share < 0.8466 + 0.015) }'

{
  sed 's/usemtl floor/usemtl grey/' lamp.obj
  cat <<'EOF'
v -3 -3 3
v 3 -3 3
v 3 3 3
v -3 3 3
vt 0 0
vt 1 0
vt 1 1
vt 0 1
v 0.2 -1 0.1
v 0.2 1 0.1
v 0.2 1 1.5
v 0.2 -1 1.5
o room
usemtl grey
f 9 12 11 10
f 1 4 12 9
f 2 10 11 3
f 1 9 10 2
f 4 3 11 12
o screen
usemtl white
f 13/1 14/2 15/3 16/4
EOF
} >room.obj
strad-import -q room.obj >room.strad
for jobs in 1 2; do strad-solve -q -j $jobs room.strad >solved.$jobs.strad; done
cmp solved.1.strad solved.2.strad
strad-check --limit 0.03 --points 300 --paths 512 solved.1.strad >report || { cat report; exit 1; }
