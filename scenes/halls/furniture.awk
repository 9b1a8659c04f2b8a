# Pieces of furniture for a place of 2 x 2 m around (x, y), of at most `most` polygons where that is enough for their
# frame. What stands on something is sunk into it by 2 mm.

# Uniform in [0, 1): Park and Miller's generator, exact in floating point.
function random() { seed = (seed * 16807) % 2147483647; return (seed - 1) / 2147483646 }

function pick(list,    names, n) { n = split(list, names, " "); return names[1 + int(random() * n)] }

# 22 polygons, 28 a chair, 5 a thing on the table.
function table(x, y, most,    start, i, s, t) {
  start = used
  material("wood")
  box(x, y, 0.72, 1.2, 0.8, 0.04, 0, 1)
  for (i = 0; i < 4; ++i) {
    s = i % 2 ? 1 : -1; t = i < 2 ? 1 : -1
    leg(x + s * 0.54, y + t * 0.34, 0.722)
  }
  for (i = 0; i < 4 && used - start + 28 <= most; ++i) chair(x + (i % 2 ? 0.3 : -0.3), y + (i < 2 ? 0.75 : -0.75), i < 2 ? 1 : -1)
  for (i = 0; i < 12 && used - start + 5 <= most; ++i) {
    material(pick("paper steel cloth"))
    box(x - 0.45 + 0.3 * (i % 4), y - 0.25 + 0.25 * int(i / 4), 0.758, 0.12 + 0.08 * random(), 0.1 + 0.08 * random(), 0.02 + 0.2 * random(), random(), 0)
  }
}

# Four sides, neither top nor bottom.
function leg(x, y, h,    v, k) {
  v = vertices
  for (k = 0; k < 8; ++k)
    vertex(x + ((k % 4 == 1 || k % 4 == 2) ? 0.025 : -0.025), y + (k % 4 >= 2 ? 0.025 : -0.025), k < 4 ? -0.002 : h)
  quad(v + 1, v + 2, v + 6, v + 5)
  quad(v + 2, v + 3, v + 7, v + 6)
  quad(v + 3, v + 4, v + 8, v + 7)
  quad(v + 4, v + 1, v + 5, v + 8)
}

# 28 polygons. The back is at the side of y that `away` says.
function chair(x, y, away,    i) {
  material("cloth")
  box(x, y, 0.43, 0.4, 0.4, 0.04, 0, 1)
  box(x, y + away * 0.18, 0.465, 0.4, 0.03, 0.45, 0, 1)
  material("steel")
  for (i = 0; i < 4; ++i) leg(x + (i % 2 ? 0.17 : -0.17), y + (i < 2 ? 0.17 : -0.17), 0.432)
}

# 22 polygons with two boards, 40 with five; 5 a book.
function shelf(x, y, most,    start, i, k, boards) {
  start = used
  material("wood")
  box(x - 0.9, y, -0.002, 0.04, 0.3, 2.0, 0, 0)
  box(x + 0.9, y, -0.002, 0.04, 0.3, 2.0, 0, 0)
  boards = most < 40 ? 2 : 5
  for (i = 0; i < boards; ++i) box(x, y, 0.1 + 0.38 * i, 1.78, 0.28, 0.03, 0, 1)
  for (i = 0; i < boards; ++i)
    for (k = 0; k < 24 && used - start + 5 <= most; ++k) {
      material(pick("paper cloth paint wood warning"))
      box(x - 0.83 + 0.072 * k, y, 0.128 + 0.38 * i, 0.03 + 0.03 * random(), 0.2, 0.2 + 0.1 * random(), 0, 0)
    }
}

# 5 polygons, twice the sides of the boiler, 12 a pipe.
function machine(x, y, most,    start, i, sides, angle) {
  start = used
  material("steel")
  box(x, y, -0.002, 1.7, 1.7, 0.25, 0, 0)
  sides = int((most - 5) / 4)
  sides = sides < 6 ? 6 : (sides > 24 ? 24 : sides)
  material(pick("paint warning steel"))
  prism(x, y, 0.248, 0.45, 1.0 + 0.8 * random(), sides)
  for (i = 0; i < 12 && used - start + 12 <= most; ++i) {
    angle = 2 * pi * (i + 0.3) / 12
    material(pick("steel paint warning"))
    prism(x + 0.68 * cos(angle), y + 0.68 * sin(angle), 0.248, 0.04 + 0.06 * random(), 0.3 + 1.2 * random(), 6)
  }
}

# 5 polygons a crate, in stacks.
function crates(x, y, most,    start, i, z, h, size, stack) {
  start = used
  for (stack = 0; stack < 9; ++stack) {
    z = -0.002
    for (i = 0; i < 3 && used - start + 5 <= most; ++i) {
      material(pick("wood wood warning paint"))
      size = 0.5 - 0.06 * i; h = 0.25 + 0.25 * random()
      box(x - 0.62 + 0.62 * (stack % 3), y - 0.62 + 0.62 * int(stack / 3), z, size, size, h, 0.3 * (random() - 0.5), 0)
      z += h - 0.002
    }
  }
}

# Blocks of 5 and 6 polygons in a pile, of exactly `count` polygons. REQUIRES: count is 0 or at least 24.
function pile(x, y, count,    closed, blocks, n, i, pitch) {
  closed = count % 5
  blocks = (count - closed) / 5
  for (n = 1; n * n * n < blocks; ++n);
  pitch = 1.6 / n
  material("paper")
  for (i = 0; i < blocks; ++i)
    box(x - 0.8 + pitch * (i % n + 0.5), y - 0.8 + pitch * (int(i / n) % n + 0.5), pitch * int(i / (n * n)) - 0.002, 0.8 * pitch, 0.8 * pitch, pitch, 0, i < closed)
}
