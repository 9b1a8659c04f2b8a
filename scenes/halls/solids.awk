# Boxes and prisms as OBJ, standing upright, at (x, y) from the height z on, turned by `yaw`. Each adds to `used`, the
# number of polygons so far.

function begin_object(name) { print "o " name }

function material(name) { if (name != current) print "usemtl " name; current = name }

BEGIN { vertex_format = "v %.4f %.4f %.4f\n" }  # a scene with small parts sets a finer one

function vertex(x, y, z) { printf vertex_format, x, y, z; return ++vertices }

function quad(a, b, c, d) { print "f " a " " b " " c " " d; ++used }

function triangle(a, b, c) { print "f " a " " b " " c; ++used }

# A free quad with its front where the corners go counter-clockwise: x, y, z of four corners in `p`.
function sheet(p,    i, c, n) {
  n = split(p, c, " ")
  for (i = 1; i < n; i += 3) vertex(c[i], c[i + 1], c[i + 2])
  quad(vertices - 3, vertices - 2, vertices - 1, vertices)
}

# Width w along x, depth d along y, height h. `closed`: with a bottom. 5 or 6 polygons.
function box(x, y, z, w, d, h, yaw, closed,    a, b, i, v, s, t) {
  a = cos(yaw); b = sin(yaw); v = vertices
  for (i = 0; i < 8; ++i) {
    s = (i % 4 == 1 || i % 4 == 2) ? w / 2 : -w / 2
    t = (i % 4 >= 2) ? d / 2 : -d / 2
    vertex(x + a * s - b * t, y + b * s + a * t, i < 4 ? z : z + h)
  }
  quad(v + 5, v + 6, v + 7, v + 8)
  quad(v + 1, v + 2, v + 6, v + 5)
  quad(v + 2, v + 3, v + 7, v + 6)
  quad(v + 3, v + 4, v + 8, v + 7)
  quad(v + 4, v + 1, v + 5, v + 8)
  if (closed) quad(v + 4, v + 3, v + 2, v + 1)
}

# Radius r, height h, n sides, a cap on top: 2 n polygons.
function prism(x, y, z, r, h, n,    i, v, angle, top, a, b) {
  v = vertices
  for (i = 0; i < n; ++i) {
    angle = 2 * pi * i / n
    vertex(x + r * cos(angle), y + r * sin(angle), z)
    vertex(x + r * cos(angle), y + r * sin(angle), z + h)
  }
  top = vertex(x, y, z + h)
  for (i = 0; i < n; ++i) {
    a = v + 2 * i + 1; b = v + 2 * ((i + 1) % n) + 1
    quad(a, b, b + 1, a + 1)
    triangle(a + 1, b + 1, top)
  }
}
