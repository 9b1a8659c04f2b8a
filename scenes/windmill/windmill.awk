# One frame of a windmill in a room, as an OBJ file: windmill.awk is given `t`, in seconds. The rotor of four blades turns by
# 90 degrees a second about an axis through (0, 2, 0.4) along z; the boat on its rails goes 1.5 m in the first 2 s and
# rests; the tower stands.
function box(name, material, x0, y0, z0, x1, y1, z1) {
  print "o " name
  print "usemtl " material
  corner(x0, y0, z0); corner(x1, y0, z0); corner(x1, y1, z0); corner(x0, y1, z0)
  corner(x0, y0, z1); corner(x1, y0, z1); corner(x1, y1, z1); corner(x0, y1, z1)
  print "f -8 -5 -6 -7\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -6 -5 -1 -2\nf -8 -4 -1 -5\nf -7 -6 -2 -3"
}
function corner(x, y, z,   u, v) {
  u = x - cx; v = y - cy
  printf "v %.6f %.6f %.6f\n", cx + u * cos(turn) - v * sin(turn) + shift, cy + u * sin(turn) + v * cos(turn), z
}
function wall(name, material, a, b, c, d) {
  print "o " name "\nusemtl " material "\nv " a "\nv " b "\nv " c "\nv " d "\nf -4 -3 -2 -1"
}
BEGIN {
  print "mtllib windmill.mtl"
  wall("floor", "plaster", "-3 0 -2", "-3 0 3", "3 0 3", "3 0 -2")
  wall("back", "brick", "-3 0 -2", "3 0 -2", "3 4 -2", "-3 4 -2")
  wall("left", "plaster", "-3 0 -2", "-3 4 -2", "-3 4 3", "-3 0 3")
  wall("right", "plaster", "3 0 -2", "3 0 3", "3 4 3", "3 4 -2")
  wall("ceiling", "plaster", "-3 4 -2", "3 4 -2", "3 4 3", "-3 4 3")
  wall("lamp", "light", "-0.6 3.99 0", "0.6 3.99 0", "0.6 3.99 1.2", "-0.6 3.99 1.2")
  box("tower", "brick", -0.3, 0, -0.3, 0.3, 2.4, 0.3)
  pi = atan2(0, -1)
  cx = 0; cy = 2; turn = pi / 2 * t
  box("hub", "wood", -0.12, 1.88, 0.34, 0.12, 2.12, 0.46)
  for (blade = 0; blade < 4; ++blade) {
    turn = pi / 2 * (t + blade)
    box("blade" blade, "sail", 0.12, 1.9, 0.38, 1.3, 2.1, 0.42)
  }
  cx = cy = turn = 0
  shift = t < 2 ? 0.75 * t : 1.5
  box("boat", "wood", -2.4, 0.05, 1.2, -1.6, 0.5, 1.7)
}
