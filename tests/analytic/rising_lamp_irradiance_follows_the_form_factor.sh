# A lamp of 1 x 1 m and radiance 10 rises over a floor, h(t) = 0.5 + t / 4. At the floor point (x, y)
#   E = Le/2 (G(a, c) + G(a, d) + G(b, c) + G(b, d)),   a, b = (0.5 -+ x) / h,   c, d = (0.5 -+ y) / h
# (scenes/rising_lamp), within 1 % at every time.
here=$STRAD_SOURCE_DIR/tests/analytic
. "$here/judge.bash"
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/rising_lamp/rising_lamp

cat >points <<'END'
0 0 0
1 0 0
0.5 0.5 0
-1.9 1.3 0
-0.3 -1.1 0
END
law=$half_grey_floor'
  function root(x) { return sqrt(1 + x * x) }
  function g(u, v) { return u / root(u) * atan2(v, root(u)) + v / root(v) * atan2(u, root(v)) }
  function pair(u, y, h) { return g(u, (0.5 - y) / h) + g(u, (0.5 + y) / h) }
  function lamp(x, y, h) { return 5 * (pair((0.5 - x) / h, y, h) + pair((0.5 + x) / h, y, h)) }
  BEGIN { while ((getline line <"points") > 0) { split(line, p, " "); x[n + 0] = p[1]; y[n + 0] = p[2]; n++ } }
  { h = 0.5 + $1 / 4; want = lamp(x[$2], y[$2], h) }'

strad-import $scene.obj | strad-motion $scene.motion | strad-solve >scene.strad
strad-probe -n 101 --points points scene.strad >table
judge 'rising lamp' "$law { judge_rgb(want, 0.01 * want) }" table

# From the solution: within the error that was asked for, 2 % of the light in the middle.
strad-probe -n 101 --points points --direct mesh scene.strad >table
judge 'rising lamp from the mesh' "$law { judge_rgb(want, 0.02 * lamp(0, 0, h)) }" table
