# A scene moved by whole metres, up to 1e6 m along each axis as georeferenced models are, has the same light: floats hold
# the corners exactly, and all else is relative to the scene. The floor under a square lamp of 2 m, 2 m above, shaded
# in part by a lid that moves, under a spotlight.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

printf 'newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n' >c.mtl
at() {  # at X: makes the scene, solves it, and prints light at two points and in two frames
  local x=$1
  awk -v x="$x" 'BEGIN {
    print "mtllib c.mtl"
    n = split("-2 0 -2,-2 0 2,2 0 2,2 0 -2,-1 2 -1,1 2 -1,1 2 1,-1 2 1,-1 1 -1,-1 1 1,0 1 1,0 1 -1", point, ",")
    for (i = 1; i <= n; ++i) { split(point[i], c, " "); printf "v %d %d %d\n", c[1] + x, c[2] + x, c[3] + x }
    print "usemtl grey\no floor\nf 1 2 3 4\nusemtl lamp\no lamp\nf 5 6 7 8\nusemtl grey\no lid\nf 9 10 11 12\nf 12 11 10 9"
  }' >far.obj
  cat >far.motion <<EOF
time 0 1
rate 2
body lid
  parts lid
  key 0 move 0 0 0
  key 1 move 1 0 0
spot s
  cone 20 30
  key 0 at $x $((x + 4)) $((x + 4)) aim $x $x $x intensity 5 5 5
camera main
  key 0 from $x $((x + 3)) $((x + 6)) to $x $x $x up 0 1 0 fov 50
EOF
  strad-import far.obj | strad-motion far.motion | strad-solve -e 0.1 >far.strad
  strad-probe -n 2 --at $x,$x,$x --at $((x - 1)),$x,$((x + 1)) far.strad >probe.$x
  strad-frame -f 1:2 -s 40x30 -o frame.$x.%d.pfm far.strad
}

at 0
# Under the middle of the lamp, seen all at 0 s but for the half behind the lid: light is there at all.
awk 'NR == 2 && !($4 > 0.05) { exit 1 }' probe.0
for x in 1000 2000 100000 1000000; do
  at $x
  diff probe.0 probe.$x
  strad-diff frame.0.%d.pfm frame.$x.%d.pfm --rel-rmse 1e-6 >/dev/null
done
