# Closed solids with curved surfaces: turned on a lathe, swept along a path, toothed. They go with solids.awk of
# ../halls. What stands on something is sunk into it by 2 mm.

# Turned about the upright axis at (x, y), n sides: `profile` has a radius and a height for each ring, from the lowest
# axis point up to the highest; radius 0 first and last. n polygons from ring to ring.
function lathe(x, y, profile, n,    p, rings, i, k, v, w, angle, low) {
  rings = split(profile, p, " ") / 2
  low = vertex(x, y, p[2])
  for (k = 2; k < rings; ++k)
    for (i = 0; i < n; ++i) {
      angle = 2 * pi * i / n
      vertex(x + p[2 * k - 1] * cos(angle), y + p[2 * k - 1] * sin(angle), p[2 * k])
    }
  vertex(x, y, p[2 * rings])
  for (i = 0; i < n; ++i) {
    v = low + 1 + i; w = low + 1 + (i + 1) % n
    triangle(low, w, v)
    for (k = 2; k < rings - 1; ++k) quad(v + (k - 2) * n, w + (k - 2) * n, w + (k - 1) * n, v + (k - 1) * n)
    triangle(v + (rings - 3) * n, w + (rings - 3) * n, vertices)
  }
}

# A tube of radius r with n sides about px, py, pz[1 .. count]; nx, ny, nz are normal to the path there. A closed one
# begins again after its last point, an open one has a lid at either end. 2 n triangles from point to point.
function tube(count, r, n, closed,    i, k, v, angle, a, b, c, s) {
  v = vertices
  for (i = 1; i <= count; ++i) {
    a = i > 1 ? i - 1 : (closed ? count : 1); b = i < count ? i + 1 : (closed ? 1 : count)
    cross(px[b] - px[a], py[b] - py[a], pz[b] - pz[a], nx[i], ny[i], nz[i])
    for (k = 0; k < n; ++k) {
      angle = 2 * pi * k / n; c = r * cos(angle); s = r * sin(angle)
      vertex(px[i] + c * nx[i] + s * crossed[1], py[i] + c * ny[i] + s * crossed[2], pz[i] + c * nz[i] + s * crossed[3])
    }
  }
  for (i = 0; i < (closed ? count : count - 1); ++i)
    for (k = 0; k < n; ++k) {
      a = v + i * n + 1; b = v + ((i + 1) % count) * n + 1; c = (k + 1) % n
      triangle(a + k, a + c, b + c); triangle(a + k, b + c, b + k)
    }
  if (closed) return
  a = vertex(px[1], py[1], pz[1]); b = vertex(px[count], py[count], pz[count])
  for (k = 0; k < n; ++k) {
    c = (k + 1) % n
    triangle(a, v + 1 + c, v + 1 + k); triangle(b, v + (count - 1) * n + 1 + k, v + (count - 1) * n + 1 + c)
  }
}

# The unit vector along a x b.
function cross(ax, ay, az, bx, by, bz,    x, y, z, length_of) {
  x = ay * bz - az * by; y = az * bx - ax * bz; z = ax * by - ay * bx
  length_of = sqrt(x * x + y * y + z * z)
  crossed[1] = x / length_of; crossed[2] = y / length_of; crossed[3] = z / length_of
}

# A wheel about an axis along y, from y to y + width: 12 polygons a tooth.
function gear(x, y, z, r, width, teeth,    i, v, angle, radius, n, a, b) {
  n = 4 * teeth; v = vertices
  for (i = 0; i < n; ++i) {
    angle = 2 * pi * i / n; radius = i % 4 < 2 ? r : 0.86 * r
    vertex(x + radius * cos(angle), y, z + radius * sin(angle))
    vertex(x + radius * cos(angle), y + width, z + radius * sin(angle))
  }
  vertex(x, y, z); vertex(x, y + width, z)
  for (i = 0; i < n; ++i) {
    a = v + 2 * i + 1; b = v + 2 * ((i + 1) % n) + 1
    quad(a, a + 1, b + 1, b)
    triangle(v + 2 * n + 1, a, b); triangle(v + 2 * n + 2, b + 1, a + 1)
  }
}

# A step of a spiral stair about (x, y), from angle a to b and radius r to s: 4 n + 2 polygons.
function step(x, y, z, h, r, s, a, b, n,    i, v, angle) {
  v = vertices
  for (i = 0; i <= n; ++i) {
    angle = a + (b - a) * i / n
    vertex(x + r * cos(angle), y + r * sin(angle), z); vertex(x + s * cos(angle), y + s * sin(angle), z)
    vertex(x + s * cos(angle), y + s * sin(angle), z + h); vertex(x + r * cos(angle), y + r * sin(angle), z + h)
  }
  quad(v + 1, v + 2, v + 3, v + 4)
  for (i = 0; i < n; ++i) {
    quad(v + 1, v + 5, v + 6, v + 2); quad(v + 2, v + 6, v + 7, v + 3)
    quad(v + 3, v + 7, v + 8, v + 4); quad(v + 4, v + 8, v + 5, v + 1)
    v += 4
  }
  quad(v + 4, v + 3, v + 2, v + 1)
}
