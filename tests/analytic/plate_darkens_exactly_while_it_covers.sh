# A plate passes between a spotlight at (0, 0, 3) and a floor (scenes/shutter): the point (x, y) is covered while
# |x/2 - x(t)| < 0.5, x(t) = -3 + t/4, if |y| < 1; else it has E = 27 / r^3, r^2 = x^2 + y^2 + 9. Dark and lit within
# 2 frames of 600 of that: at a plate's speed of 0.01 m a frame, |x/2 - x(t)| is known to 0.02.
here=$STRAD_SOURCE_DIR/tests/analytic
. "$here/judge.bash"
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/shutter/shutter

cat >points <<'END'
0 0 0
0.8 0.4 0
-1 -0.9 0
1.3 -1.2 0
END
law=$half_grey_floor'
  BEGIN { while ((getline line <"points") > 0) { split(line, p, " "); x[n + 0] = p[1]; y[n + 0] = p[2]; n++ } }
  {
    off = x[$2] / 2 + 3 - $1 / 4
    if (off < 0) off = -off
    never = y[$2] * y[$2] > 1
    lit = 27 / (x[$2] * x[$2] + y[$2] * y[$2] + 9) ^ 1.5
    edge = !never && off > 0.48 && off < 0.52
    want = never || off > 0.5 ? lit : 0
    seen[$2, want > 0]++
  }'

strad-import $scene.obj | strad-motion $scene.motion | strad-solve >scene.strad
strad-probe --frames --points points scene.strad >table
judge shutter "$law !edge { judge_rgb(want, 0.001 * lit) }
  END { if (seen[0, 0] < 98 || seen[0, 1] < 490 || seen[3, 1] < 600) { print \"points missed\"; exit 1 } }" table

# From the solution: farther than 20 frames (two cells of time) from an edge as exactly; 2 frames from it on the right
# side of one half.
strad-probe --frames --points points --direct mesh scene.strad >table
judge 'shutter from the mesh' "$law
  !edge && off > 0.3 && off < 0.7 && !never { judge(\$7 > lit / 2, want > 0, 0.5); next }
  !edge { judge_rgb(want, 0.01 * lit) }" table
