# Small scenes, each of a kind that is hard for a solver. They go with solids.awk of ../halls and turned.awk of ../complex:
#
#   awk -v kind=doors -v library=doors.mtl -f ../halls/solids.awk -f ../complex/turned.awk -f trials.awk
#
# What stands on something is sunk into it by 2 mm.

# An empty room from (0, 0, 0) to (w, d, h), its sides facing inwards.
function room(w, d, h) {
  begin_object("floor")
  material("wood")
  sheet("0 0 0 " w " 0 0 " w " " d " 0 0 " d " 0")
  begin_object("ceiling")
  material("white")
  sheet("0 0 " h " 0 " d " " h " " w " " d " " h " " w " 0 " h)
  begin_object("walls")
  material("white")
  sheet("0 0 0 0 0 " h " " w " 0 " h " " w " 0 0"); sheet(w " " d " 0 " w " " d " " h " 0 " d " " h " 0 " d " 0")
  material("red")
  sheet(w " 0 0 " w " 0 " h " " w " " d " " h " " w " " d " 0")
  material("blue")
  sheet("0 " d " 0 0 " d " " h " 0 0 " h " 0 0 0")
}

# A lamp of w x d about (x, y), the bottom of a flat box, shining down from the height z.
function lamp(x, y, z, w, d,    a, b, c, e) {
  begin_object("lamp")
  material("steel")
  box(x, y, z, w, d, 0.05, 0, 0)
  material("lamp")
  a = x - w / 2; b = x + w / 2; c = y - d / 2; e = y + d / 2
  sheet(a " " c " " z " " a " " e " " z " " b " " e " " z " " b " " c " " z)
}

# A wall across the room at x, 0.12 thick, with a gap from y = a to b up to the height `top`.
function wall(name, x, d, h, a, b, top) {
  begin_object(name)
  material("white")
  if (a > 0) box(x, a / 2, -0.002, 0.12, a, h + 0.004, 0, 1)
  if (b < d) box(x, (b + d) / 2, -0.002, 0.12, d - b, h + 0.004, 0, 1)
  if (top < h) box(x, (a + b) / 2, top, 0.12, b - a, h - top + 0.002, 0, 1)
}

function table(name, x, y, yaw,    i) {
  begin_object(name)
  material("wood")
  box(x, y, 0.7, 1.4, 0.8, 0.04, yaw, 1)
  material("steel")
  for (i = 0; i < 4; ++i)
    box(x + 0.6 * (i % 2 ? 1 : -1) * cos(yaw) - 0.32 * (i > 1 ? 1 : -1) * sin(yaw),
        y + 0.6 * (i % 2 ? 1 : -1) * sin(yaw) + 0.32 * (i > 1 ? 1 : -1) * cos(yaw), -0.002, 0.05, 0.05, 0.704, yaw, 0)
}

# Three rooms in a row; the last is lit through two doors only, and has a shelf of books.
function doors(    i) {
  room(9, 4, 2.5)
  wall("first_wall", 3, 4, 2.5, 2.6, 3.5, 2.05)
  wall("second_wall", 6, 4, 2.5, 0.6, 1.5, 2.05)
  begin_object("door")
  material("wood")
  box(3, 3.04, 0.01, 0.04, 0.86, 2.02, 0, 1)
  lamp(1.4, 1.5, 2.3, 0.6, 0.6)
  table("table", 1.2, 2.9, 0.2)
  begin_object("shelf")
  material("wood")
  for (i = 0; i < 4; ++i) box(8.82, 2, 0.4 + 0.4 * i, 0.3, 1.6, 0.03, 0, 1)
  for (i = 0; i < 2; ++i) box(8.82, 1.18 + 1.64 * i, -0.002, 0.32, 0.04, 2, 0, 1)
  begin_object("books")
  for (i = 0; i < 36; ++i) {
    material(i % 3 ? (i % 2 ? "red" : "blue") : "white")
    box(8.82, 1.3 + 0.12 * (i % 12), 0.428 + 0.4 * int(i / 12), 0.2, 0.04 + 0.01 * (i % 4), 0.2 + 0.02 * (i % 5), 0, 1)
  }
}

# A hall of 30 m, and parcels of half a metre on a belt in a corner of it.
function belt(    i) {
  room(30, 12, 7)
  for (i = 0; i < 3; ++i) lamp(4 + 11 * i, 4, 5, 2.4, 0.4)
  begin_object("belt")
  material("steel")
  box(5, 3, -0.002, 9, 0.9, 0.752, 0, 1)
  for (i = 0; i < 6; ++i) {
    begin_object("parcel" i)
    material(i % 2 ? "wood" : "red")
    box(1.2 + 1.1 * i, 3, 0.748, 0.3 + 0.05 * (i % 3), 0.4, 0.25 + 0.06 * (i % 4), 0.3 * i, 0)
  }
  begin_object("racks")
  material("wood")
  for (i = 0; i < 24; ++i) box(1.5 + 2.4 * (i % 12), 0.6, 0.5 + 0.9 * int(i / 12), 2, 0.8, 0.03, 0, 1)
  material("steel")
  for (i = 0; i < 26; ++i) box(0.4 + 2.4 * (i % 13), 0.3 + 0.6 * int(i / 13), -0.002, 0.05, 0.05, 2, 0, 0)
}

# Two trusses of bars of 2 to 4 cm whose ends are inside of one another, under a ceiling; a lamp slides below them.
function beams(    i, k, y) {
  room(6, 5, 3)
  for (k = 0; k < 2; ++k) {
    begin_object("truss" k)
    y = 1.5 + 2 * k
    material("red")
    box(3, y, 2.5, 5.9, 0.06, 0.06, 0, 1)
    box(3, y, 2.85, 5.9, 0.06, 0.06, 0, 1)
    material("steel")
    for (i = 0; i < 20; ++i) box(0.2 + 0.29 * i, y, 2.55, 0.03, 0.03, 0.31, 0, 1)
  }
  begin_object("posts")
  material("steel")
  for (i = 0; i < 8; ++i) box(1 + 1.3 * (i % 4), 1.5 + 2 * int(i / 4), -0.002, 0.04, 0.04, 2.51, 0, 0)
  lamp(1, 2.5, 2.2, 0.8, 0.3)
  table("table", 3, 2.5, 0.5)
}

# Four blades that turn twice a second under the lamp; two chairs.
function fan(    i) {
  room(5, 4, 2.8)
  lamp(2.5, 2, 2.7, 0.7, 0.7)
  begin_object("fan")
  material("wood")
  for (i = 0; i < 4; ++i) box(2.5 + 0.55 * cos(pi * i / 2), 2 + 0.55 * sin(pi * i / 2), 2.3, 0.9, 0.16, 0.01, pi * i / 2, 1)
  material("steel")
  prism(2.5, 2, 2.24, 0.12, 0.12, 12)
  for (i = 0; i < 2; ++i) {
    begin_object("chair" i)
    material(i ? "blue" : "red")
    box(1.6 + 1.7 * i, 1.5 + 0.9 * i, 0.42, 0.44, 0.42, 0.05, 0.4 + i, 1)
    box(1.6 + 1.7 * i - 0.2 * cos(0.4 + i), 1.5 + 0.9 * i - 0.2 * sin(0.4 + i), -0.002, 0.04, 0.42, 0.9, 0.4 + i, 0)
    box(1.6 + 1.7 * i + 0.2 * cos(0.4 + i), 1.5 + 0.9 * i + 0.2 * sin(0.4 + i), -0.002, 0.04, 0.42, 0.43, 0.4 + i, 0)
  }
}

# A curved body of 5,000 small polygons on a turntable, under a lamp.
function statue(    i, profile, z) {
  room(4, 4, 3)
  lamp(2, 1.4, 2.8, 0.8, 0.8)
  begin_object("plinth")
  material("white")
  prism(2, 2, -0.002, 0.5, 0.502, 24)
  begin_object("statue")
  material("wood")
  profile = "0 0.498"
  for (i = 1; i < 50; ++i) {
    z = i / 50
    profile = profile " " (0.12 + 0.2 * sin(pi * z) * (1 + 0.3 * sin(14 * z))) " " (0.498 + 1.2 * z)
  }
  vertex_format = "v %.6f %.6f %.6f\n"
  lathe(2.12, 2, profile " 0 1.698", 100)
}

# A dark room behind a wall with a slit of 2 cm; in the room before it a spotlight swings over the slit.
function slit() {
  room(6, 4, 2.6)
  wall("wall", 2.5, 4, 2.6, 1.99, 2.01, 1.9)
  begin_object("block")
  material("white")
  box(4.5, 2.4, -0.002, 0.7, 0.7, 0.9, 0.4, 0)
}

BEGIN {
  pi = atan2(0, -1)
  print "mtllib " library
  if (kind == "doors") doors()
  else if (kind == "belt") belt()
  else if (kind == "beams") beams()
  else if (kind == "fan") fan()
  else if (kind == "statue") statue()
  else if (kind == "slit") slit()
}
