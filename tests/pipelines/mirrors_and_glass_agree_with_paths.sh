# Mirrors and glass, for the solve and for the eye: a room with a mirror, brushed metal, a tinted pane and clear glass is
# as path tracing shows it, the layers of light add up, and nothing depends on the number of threads.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
glass=$STRAD_SOURCE_DIR/scenes/glass
strad-import -q "$glass/glass.obj" | strad-motion -q "$glass/glass.motion" >scene.strad
for jobs in 1 2; do
  strad-solve -q -j $jobs --at 0 scene.strad >solved.$jobs.strad
  strad-frame -q -j $jobs -t 0 -s 120x90 --pfm solved.$jobs.strad >frame.$jobs.pfm
done
cmp solved.1.strad solved.2.strad
cmp frame.1.pfm frame.2.pfm
strad-frame -q -t 0 -s 120x90 -o frame.exr solved.1.strad
strad-frame -q -t 0 -s 120x90 --reference 400 -o paths.exr scene.strad
strad-diff --rel-rmse 0.05 frame.exr paths.exr >report || { cat report; exit 1; }
cat report

# A furnace of surfaces that emit 1 and reflect 0.5 has a radiance of 2 everywhere.
cat >furnace.mtl <<'END'
newmtl wall
Kd 0.5 0.5 0.5
Ke 1 1 1
newmtl mirror
Kd 0 0 0
Ks 0.9 0.9 0.9
illum 3
newmtl clear
Kd 0 0 0
Tf 1 1 1
Ni 1.1
illum 7
END
cube() { # SIZE: corners
  awk -v s="$1" 'BEGIN { for (i = 0; i < 8; i++) print "v", s*(i%2*2-1), s*(int(i/2)%2*2-1), s*(int(i/4)*2-1) }'
}
{
  echo mtllib furnace.mtl
  cube 2
  cube 0.5
  printf '%s\n' 'o room' 'usemtl wall' 'f 1 2 4 3' 'f 5 7 8 6' 'f 1 5 6 2' 'f 3 4 8 7' 'f 1 3 7 5' 'f 2 6 8 4'
  printf '%s\n' 'o block' 'usemtl clear' 'f 9 11 12 10' 'f 13 14 16 15' 'f 9 10 14 13' 'f 11 15 16 12' 'f 9 13 15 11' 'f 10 12 16 14'
} >clear.obj
printf 'camera main\n  key 0 from 1.5 1.2 1.8 to 0 0 0 up 0 1 0 fov 50\n' >furnace.motion
# Glass that takes nothing does not show, whatever it bends: the radiance behind is 2 as well. (With an index of 1.1 it
# mirrors only 0.2 %; light that glass mirrors onto diffuse surfaces is not carried, like that of mirrors.)
strad-import -q clear.obj | strad-motion -q furnace.motion | strad-solve -q >clear.strad
strad-frame -q -s 40x30 --pfm clear.strad >clear.pfm
mean() { # FILE: of the numbers of a PFM file
  tail -c $((40 * 30 * 12)) "$1" | od -An -v -t f4 | awk '{ for (i = 1; i <= NF; i++) { s += $i; n++ } } END { print s / n }'
}
mean clear.pfm | awk '{ print "radiance around glass", $1; exit !($1 > 1.98 && $1 < 2.02) }'
sed 's/usemtl clear/usemtl mirror/' clear.obj >mirror.obj
# The solve takes the mirror for black. The room is 16 times as large as the block, which sees nothing else, so walls see
# the block in 1/16 of their view in the mean, at most 0.13 in the middle of a wall, at least 0.03 in a corner. With B = 1 +
# 0.5 (1 - share) 1.88, where 1.88 is the mean B = 1 / (1 - 0.5 (1 - 1/16)), a wall has 1.81 to 1.92; of that 0.9 is seen.
strad-import -q mirror.obj | strad-motion -q furnace.motion | strad-solve -q >mirror.strad
strad-frame -q -s 40x30 --pfm mirror.strad >mirror.pfm
tail -c $((40 * 30 * 12)) mirror.pfm | od -An -v -t f4 | tr -s ' ' '\n' | grep . | sed -n $(((15 * 40 + 20) * 3 + 1))p |
  awk '{ print "radiance in a mirror", $1; exit !($1 > 1.62 && $1 < 1.74) }'
