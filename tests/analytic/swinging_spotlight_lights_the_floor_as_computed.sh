# A spotlight of 60 W/sr hangs 1 m below the pivot (0, 0, 4) and swings about +y, a(t) = -30..30..-30 degrees:
#   s = (-sin a, 0, 4 - cos a),   d = (-sin a, 0, -cos a),   w = p - s,   r = |w|
#   E = 60 smoothstep(cos 25, cos 15, dot(d, w) / r) s_z / r^3     (scenes/swing)
# within 2 % of the brightest light that passes the point.
here=$STRAD_SOURCE_DIR/tests/analytic
. "$here/judge.bash"
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/swing/swing

cat >points <<'END'
0 0 0
1 0 0
1.5 0.5 0
0.5 -1 0
-2 0.2 0
END
law=$half_grey_floor'
  BEGIN {
    degree = atan2(0, -1) / 180
    while ((getline line <"points") > 0) { split(line, p, " "); x[n + 0] = p[1]; y[n + 0] = p[2]; n++ }
  }
  {
    a = ($1 <= 5 ? -30 + 12 * $1 : 30 - 12 * ($1 - 5)) * degree
    height = 4 - cos(a)
    wx = x[$2] + sin(a); wy = y[$2]; wz = -height
    r = sqrt(wx * wx + wy * wy + wz * wz)
    t = ((-sin(a) * wx - cos(a) * wz) / r - cos(25 * degree)) / (cos(15 * degree) - cos(25 * degree))
    t = t < 0 ? 0 : t > 1 ? 1 : t
    want = 60 * t * t * (3 - 2 * t) * height / (r * r * r)
  }'

strad-import $scene.obj | strad-motion $scene.motion | strad-solve >scene.strad
strad-probe -n 401 --points points scene.strad >table
judge 'swing' "$law { judge_rgb(want, 0.001 * want + 0.001) }" table
strad-probe -n 401 --points points --direct mesh scene.strad >table
judge 'swing from the mesh' "$law { judge_rgb(want, 0.02 * 6.67) }" table
