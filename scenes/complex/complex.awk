# The room of ../room4 with its four boxes replaced: a spiral stair, a bookcase of books and vases, a machine that slides
# on rails, a torus knot on a turntable. Variables: polygons, library.

function random() { seed = (seed * 16807) % 2147483647; return (seed - 1) / 2147483646 }

function pick(list,    names, n) { n = split(list, names, " "); return names[1 + int(random() * n)] }

BEGIN {
  pi = atan2(0, -1); seed = 2001; used = 0; vertices = 0
  vertex_format = "v %.6f %.6f %.6f\n"
  print "# room4 with complex models in place of its boxes: about " polygons " polygons"
  print "mtllib " library
  room()
  stair(4.6, 4.7, polygons / 4)
  bookcase(4.5, 2.0, 0.61, polygons / 4)
  machine(1.7, 2.25, polygons / 5)
  knot(2.2, 4.6)
}

function room() {
  surface("floor", "white", "0 0 0 6 0 0 6 6 0 0 6 0")
  surface("ceiling", "white", "0 0 3 0 6 3 6 6 3 6 0 3")
  surface("wall_red", "red", "6 0 0 6 0 3 6 6 3 6 6 0")
  surface("wall_green", "green", "0 6 0 6 6 0 6 6 3 0 6 3")
  surface("wall_blue", "blue", "0 0 0 0 6 0 0 6 3 0 0 3")
  surface("wall_grey", "grey", "0 0 0 0 0 3 6 0 3 6 0 0")
  material("metal")
  begin_object("housing")
  box(3.2, 3.4, 2, 0.24, 0.24, 0.2, 0, 1)
  begin_object("cart")
  box(0.9, 3.5, -0.002, 0.4, 0.3, 0.3, 0, 0)
}

function surface(name, colour, corners) { begin_object(name); material(colour); sheet(corners) }

# Fourteen steps about a column, a baluster on each, a handrail.
function stair(x, y, count,    i, n, angle, z, rings, points) {
  begin_object("stair")
  material("metal")
  lathe(x, y, "0 -0.002 0.07 -0.002 0.07 2.1 0 2.1", 24)
  for (i = 0; i < 14; ++i) {
    angle = i * pi / 8; z = 0.05 + 0.12 * i
    material("oak")
    n = int((count / 42 - 2) / 4)
    step(x, y, z, 0.04, 0.068, 0.52, angle, angle + pi / 8, n < 1 ? 1 : n)
    material("iron")
    rings = "0 " z + 0.038 " " wavy(0.012, 0.02, z + 0.038, z + 0.45, int(count / 42 / 10) - 1) " 0 " z + 0.45
    lathe(x + 0.47 * cos(angle + pi / 16), y + 0.47 * sin(angle + pi / 16), rings, 10)
  }
  n = int(sqrt(count / 60)); if (n < 4) n = 4
  points = int(count / 6 / n)
  for (i = 1; i <= points; ++i) {
    angle = pi / 16 + 13 * pi / 8 * (i - 1) / (points - 1)
    nx[i] = cos(angle); ny[i] = sin(angle); nz[i] = 0
    px[i] = x + 0.47 * nx[i]; py[i] = y + 0.47 * ny[i]; pz[i] = 0.52 + 0.12 * 13 * (i - 1) / (points - 1)
  }
  material("oak")
  tube(points, 0.024, n, 0)
}

# Rings of a profile between two radii and two heights, at least 2.
function wavy(r, s, z0, z1, rings,    i, u, text) {
  if (rings < 2) rings = 2
  for (i = 0; i < rings; ++i) {
    u = i / (rings - 1)
    text = text sprintf("%s%.5f %.5f", i ? " " : "", r + (s - r) * (0.5 - 0.5 * cos(6 * pi * u)), z0 + (z1 - z0) * u)
  }
  return text
}

# Four boards with things on either side of a back; every fourth is a vase, the others are books.
function bookcase(x, y, yaw, count,    board, side, slot, vase) {
  begin_object("bookcase")
  material("oak")
  for (slot = -1; slot <= 1; slot += 2) box(x + slot * 0.44 * cos(yaw), y + slot * 0.44 * sin(yaw), -0.002, 0.03, 0.5, 1.2, yaw, 1)
  box(x, y, 0.02, 0.854, 0.02, 1.16, yaw, 1)
  for (board = 0; board < 5; ++board)
    for (side = -1; side <= 1; side += 2) box(x - side * 0.128 * sin(yaw), y + side * 0.128 * cos(yaw), 0.02 + 0.285 * board, 0.854, 0.24, 0.02, yaw, 1)
  vase = (count - 72 - 120 * 6) / 40
  for (slot = 0; slot < 160; ++slot) {
    board = int(slot / 40); side = slot % 2 ? 1 : -1
    thing(x, y, yaw, -0.399 + 0.042 * (int(slot / 2) % 20), side * 0.13, 0.038 + 0.285 * board, int(slot / 2) % 4 == 1, vase)
  }
}

# A vase or a book at (u, v) of the bookcase.
function thing(x, y, yaw, u, v, z, round, count,    n, rings, h) {
  x += u * cos(yaw) - v * sin(yaw); y += u * sin(yaw) + v * cos(yaw)
  if (!round) {
    material(pick("red green blue paper oak"))
    box(x, y, z, 0.018 + 0.018 * random(), 0.14 + 0.06 * random(), 0.16 + 0.08 * random(), yaw, 1)
    return
  }
  material(pick("white glaze clay"))
  h = 0.12 + 0.1 * random()
  n = int(sqrt(count)); if (n < 4) n = 4
  rings = int(count / n) - 1
  lathe(x, y, "0 " z " " wavy(0.012, 0.0195, z, z + h, rings) " 0 " z + h, n)
}

# A bed with gears, a flywheel, pipes and bolts, on two rails.
function machine(x, y, count,    i, n) {
  begin_object("rails")
  material("iron")
  for (i = -1; i <= 1; i += 2) box(x + 0.65, y + i * 0.22, -0.002, 2.3, 0.04, 0.05, 0, 1)
  begin_object("machine")
  box(x, y, 0.052, 0.8, 0.6, 0.1, 0, 1)
  material("glaze")
  box(x, y - 0.07, 0.15, 0.6, 0.14, 0.45, 0, 1)
  gears(x, y, count)
  flywheel(x + 0.2, y - 0.21, 0.42, 0.3 * count)
  pipes(x, y, 0.3 * count)
  material("brass")
  n = int(0.1 * count / 24)
  for (i = 0; i < 24; ++i) lathe(x - 0.36 + 0.065 * (i % 12), y + (i < 12 ? -0.28 : 0.28), "0 0.15 0.014 0.15 0.014 0.175 0 0.175", int(n / 3) < 4 ? 4 : int(n / 3))
}

# Along one side of the block, on its face and clear of each other.
function gears(x, y, count,    teeth) {
  teeth = int(0.1 * count / 12); if (teeth < 6) teeth = 6
  material("brass")
  gear(x - 0.19, y - 0.002, 0.3, 0.1, 0.05, teeth)
  gear(x + 0.01, y - 0.002, 0.36, 0.09, 0.05, teeth)
  gear(x + 0.2, y - 0.002, 0.46, 0.1, 0.05, teeth)
}

# A ring about an axis along y and its hub of four spokes.
function flywheel(x, y, z, count,    n, points, i, angle) {
  material("red")
  n = int(sqrt(count / 12)); if (n < 4) n = 4
  points = int(count / 2 / n)
  for (i = 1; i <= points; ++i) {
    angle = 2 * pi * i / points
    nx[i] = cos(angle); ny[i] = 0; nz[i] = sin(angle)
    px[i] = x + 0.17 * nx[i]; py[i] = y; pz[i] = z + 0.17 * nz[i]
  }
  tube(points, 0.028, n, 1)
  material("iron")
  box(x, y, z - 0.144, 0.03, 0.03, 0.288, 0, 1)
  for (i = -1; i <= 1; i += 2) box(x + i * 0.079, y, z - 0.015, 0.13, 0.03, 0.03, 0, 1)
  box(x, y + 0.042, z - 0.02, 0.04, 0.058, 0.04, 0, 1)
}

# Three arches over the bed.
function pipes(x, y, count,    pipe, n, points, i, angle) {
  n = int(sqrt(count / 24)); if (n < 4) n = 4
  points = int(count / 6 / n); if (points < 3) points = 3
  for (pipe = 0; pipe < 3; ++pipe) {
    material(pick("brass metal clay"))
    for (i = 1; i <= points; ++i) {
      angle = pi * (i - 1) / (points - 1)
      nx[i] = cos(angle); ny[i] = 0; nz[i] = sin(angle)
      px[i] = x + 0.3 * nx[i]; py[i] = y + 0.11 + 0.06 * pipe; pz[i] = 0.15 + 0.3 * nz[i] + 0.1 * pipe * nz[i] * nz[i]
    }
    tube(points, 0.022, n, 0)
  }
}

# On a plinth; takes the polygons that are left.
function knot(x, y,    n, points, i, angle, r, h) {
  begin_object("plinth")
  material("clay")
  lathe(x, y, "0 -0.002 0.4 -0.002 0.4 0.06 0.34 0.1 0.34 0.34 0.4 0.38 0.4 0.42 0 0.42", 48)
  begin_object("knot")
  material("iron")
  lathe(x, y, "0 0.423 0.38 0.423 0.38 0.448 0 0.448", 48)
  n = int(sqrt((polygons - used) / 20)); if (n < 4) n = 4
  points = int((polygons - used) / 2 / n)
  for (i = 1; i <= points; ++i) {
    angle = 2 * pi * i / points
    r = cos(3 * angle); h = sin(3 * angle)
    nx[i] = r * cos(2 * angle); ny[i] = r * sin(2 * angle); nz[i] = h
    px[i] = x + 0.3 * cos(2 * angle) + 0.13 * nx[i]; py[i] = y + 0.3 * sin(2 * angle) + 0.13 * ny[i]; pz[i] = 0.631 + 0.13 * h
  }
  material("white")
  tube(points, 0.055, n, 1)
}
