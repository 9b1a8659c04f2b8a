# Halls in rows, with doors between them. Each has lamps, a rotor that turns and a carriage under the ceiling that
# slides along the middle aisle and carries a spotlight. Variables: polygons, library, motion (a file name).

BEGIN {
  pi = atan2(0, -1); seed = 20011; used = 0; vertices = 0
  halls = int(sqrt(polygons / 1000) + 0.5)
  columns = int(sqrt(halls - 0.5)) + 1
  cells = 2 * int((polygons / halls / 12) ^ (1 / 3) / 2) + 1  # a side, odd: the middle row and column are aisles
  if (cells < 3) cells = 3
  cell = 2.5; side = cells * cell; height = 4.5
  print "# Halls of furniture and machines: " polygons " polygons in " halls " halls"
  print "mtllib " library
  print "# halls: rotors turn, carriages slide and carry spotlights\ntime 0 12\nrate 25" >motion
  for (hall = 0; hall < halls; ++hall) build(hall, side * (hall % columns), side * int(hall / columns))
  printf "\ncamera main\n  key 0 from %.4f 0.6 2.8 to %.4f %.4f 1 up 0 0 1 fov 60\n", side - 0.6, side * 0.4, side * 0.6 >motion
}

function build(hall, x, y,    goal) {
  goal = int(polygons * (hall + 1) / halls)
  shell(hall, x, y)
  lamps(hall, x, y)
  carriage(hall, x + side / 2, y)
  rotor(hall, x + cell / 2, y + cell / 2)
  furnish(hall, x, y, goal)
}

function has(hall) { return hall >= 0 && hall < halls }

# Floor, ceiling and walls. A hall has its west and south walls, and the others where no hall follows.
function shell(hall, x, y,    first, last) {
  first = hall % columns == 0; last = hall % columns == columns - 1 || !has(hall + 1)
  begin_object("h" hall "_shell")
  material("floor")
  sheet(x " " y " 0 " x + side " " y " 0 " x + side " " y + side " 0 " x " " y + side " 0")
  material("ceiling")
  sheet(x " " y " " height " " x " " y + side " " height " " x + side " " y + side " " height " " x + side " " y " " height)
  material("wall")
  wall(x, y + side, x, y, !first)
  wall(x, y, x + side, y, has(hall - columns))
  if (last) wall(x + side, y, x + side, y + side, 0)
  if (!has(hall + columns)) wall(x + side, y + side, x, y + side, 0)
}

# From (x0, y0) to (x1, y1), its front to the left of that way; a door of 2 x 2.5 m in the middle where one is wanted.
function wall(x0, y0, x1, y1, door,    a, b) {
  if (!door) { upright(x0, y0, x1, y1, 0); return }
  a = 0.5 - 1 / side; b = 0.5 + 1 / side
  upright(x0, y0, x0 + a * (x1 - x0), y0 + a * (y1 - y0), 0)
  upright(x0 + b * (x1 - x0), y0 + b * (y1 - y0), x1, y1, 0)
  upright(x0 + a * (x1 - x0), y0 + a * (y1 - y0), x0 + b * (x1 - x0), y0 + b * (y1 - y0), 2.5)
}

function upright(x0, y0, x1, y1, z) {
  sheet(x1 " " y1 " " z " " x0 " " y0 " " z " " x0 " " y0 " " height " " x1 " " y1 " " height)
}

# Four a hall, a sixteenth of the ceiling.
function lamps(hall, x, y,    i, u, v, r) {
  r = side / 16
  begin_object("h" hall "_lamps")
  for (i = 0; i < 4; ++i) {
    u = x + side * (i % 2 ? 0.75 : 0.25); v = y + side * (i < 2 ? 0.25 : 0.75)
    material("steel")
    box(u, v, height - 0.2, 2 * r, 2 * r, 0.1, 0, 0)
    material("lamp")
    sheet(u - r " " v - r " " height - 0.2 " " u - r " " v + r " " height - 0.2 " " u + r " " v + r " " height - 0.2 " " u + r " " v - r " " height - 0.2)
  }
}

function carriage(hall, x, y,    name, far) {
  name = "h" hall "_carriage"; far = side - 2
  begin_object("h" hall "_rail")
  material("steel")
  box(x, y + side / 2, 3.75, 0.12, side - 0.6, 0.2, 0, 1)
  begin_object(name)
  material("warning")
  box(x, y + 1, 3.3, 0.8, 0.5, 0.35, 0, 1)
  material("steel")
  box(x, y + 1, 2.9, 0.25, 0.25, 0.3, 0, 1)
  printf "\nbody %s\n  parts %s\n  ease smooth\n", name, name >motion
  printf "  key 0 move 0 %.4f 0\n  key 6 move 0 %.4f 0\n  key 12 move 0 %.4f 0\n", hall % 2 ? far : 0, hall % 2 ? 0 : far, hall % 2 ? far : 0 >motion
  printf "\nspot h%d_spot\n  on %s\n  cone 24 34\n  key 0 at %.4f %.4f 2.8 aim %.4f %.4f 0 intensity 45 42 36\n", hall, name, x, y + 1, x + 1.2, y + 1.6 >motion
}

# A stand, and on it a hub with four blades that turns.
function rotor(hall, x, y,    i, angle, name) {
  name = "h" hall "_rotor"
  begin_object("h" hall "_stand")
  material("steel")
  box(x, y, -0.002, 0.5, 0.5, 0.9, 0, 0)
  begin_object(name)
  material("paint")
  prism(x, y, 0.91, 0.16, 0.9, 8)
  material("warning")
  for (i = 0; i < 4; ++i) {
    angle = pi * i / 2
    box(x + 0.55 * cos(angle), y + 0.55 * sin(angle), 1.0, 0.76, 0.05, 0.7, angle, 1)
  }
  printf "\nbody %s\n  parts %s\n  pivot %.4f %.4f 0\n  axis 0 0 1\n", name, name, x, y >motion
  printf "  key 0 turn 0\n  key 12 turn %d\n", (hall % 2 ? -1 : 1) * (180 + 90 * (hall % 3)) >motion
}

# Fills the places beside the aisles until `goal` polygons are there; the last place takes what is then missing.
function furnish(hall, x, y, goal,    place, places, row, column, middle) {
  middle = (cells - 1) / 2
  places = (cells - 1) * (cells - 1)
  for (place = 1; place < places; ++place) {  # the first has the rotor
    row = int(place / (cells - 1)); column = place % (cells - 1)
    if (row >= middle) ++row
    if (column >= middle) ++column
    furnish_place(hall, place, x + cell * (column + 0.5), y + cell * (row + 0.5), goal, places - place)
  }
}

function furnish_place(hall, place, x, y, goal, left,    most, kind) {
  # The last place needs some polygons for a whole number of blocks.
  most = left == 1 ? goal - used : int((goal - used - 30) / left)
  kind = left == 1 ? "pile" : pick("table shelf machine crates")
  # What there is no room for is left out: no frame is larger than 34 polygons.
  if (kind != "pile" && goal - used - most < 30) return
  if (kind != "pile" && most < 34) kind = "crates"
  begin_object("h" hall "_" kind place)
  if (kind == "table") table(x, y, most)
  else if (kind == "shelf") shelf(x, y, most)
  else if (kind == "machine") machine(x, y, most)
  else if (kind == "crates") crates(x, y, most)
  else pile(x, y, most)
}
