# A closed room with 180 small boxes in it, all of reflectance rho = 0.7, lit by two spotlights. All light is absorbed
# in the end: the integral of (1 - rho) E over all surfaces is the power of the spotlights,
#   2 pi I0 (1 - (cos inner + cos outer) / 2) each,
# since smoothstep is 1/2 in the mean over the cosines between the two. Within 1 %. E = pi L / rho is linear between
# the vertices of the PLY mesh, so its integral is a sum over triangles; their area is that of room and boxes.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

cat >boxes.awk <<'END'
function random() { seed = (seed * 16807) % 2147483647; return (seed - 1) / 2147483646 }

BEGIN {
  seed = 3
  print "mtllib boxes.mtl\nusemtl grey"
  begin_object("room")
  sheet("0 0 0 4 0 0 4 4 0 0 4 0"); sheet("0 0 3 0 4 3 4 4 3 4 0 3")
  sheet("0 0 0 0 0 3 4 0 3 4 0 0"); sheet("4 4 0 4 4 3 0 4 3 0 4 0")
  sheet("4 0 0 4 0 3 4 4 3 4 4 0"); sheet("0 4 0 0 4 3 0 0 3 0 0 0")
  area = 80
  for (i = 0; i < 180; ++i) {
    size = 0.12 + 0.2 * random()
    begin_object("box" i)
    box(0.5 + 0.6 * (i % 6) + 0.1 * random(), 0.5 + 0.6 * (int(i / 6) % 6) + 0.1 * random(), 0.4 + 0.5 * int(i / 36) + 0.1 * random() - size / 2, size, size, size, random(), 1)
    area += 6 * size * size
  }
  print area >"area"
}
END
printf 'newmtl grey\nKd 0.7 0.7 0.7\n' >boxes.mtl
cat >boxes.motion <<'END'
time 0 1
spot corner
  cone 40 55
  key 0 at 0.3 0.4 2.8 aim 2 2 1 intensity 20 20 20
spot wall
  cone 20 60
  key 0 at 3.8 2.1 1.4 aim 0 2.3 1.2 intensity 10 10 10
END

# Bytes of vertices, then of triangles, as decimal numbers.
cat >integral.awk <<'END'
function number(i) { return $i + 256 * ($(i + 1) + 256 * ($(i + 2) + 256 * $(i + 3))) }
function single(i,    bits, exponent, sign) {
  bits = number(i)
  sign = bits >= 2147483648 ? -1 : 1
  bits %= 2147483648
  exponent = int(bits / 8388608)
  return exponent == 0 ? 0 : sign * (1 + bits % 8388608 / 8388608) * 2 ^ (exponent - 127)
}
FILENAME == "vertices" { x[n + 0] = single(1); y[n + 0] = single(5); z[n + 0] = single(9); radiance[n++ + 0] = single(16); next }
{
  a = number(2); b = number(6); c = number(10)
  ux = x[b] - x[a]; uy = y[b] - y[a]; uz = z[b] - z[a]
  vx = x[c] - x[a]; vy = y[c] - y[a]; vz = z[c] - z[a]
  size = sqrt((uy * vz - uz * vy) ^ 2 + (uz * vx - ux * vz) ^ 2 + (ux * vy - uy * vx) ^ 2) / 2
  area += size
  integral += size * (radiance[a] + radiance[b] + radiance[c]) / 3
}
END {
  pi = atan2(0, -1); degree = pi / 180; rho = 0.7
  power = 2 * pi * (20 * (1 - (cos(40 * degree) + cos(55 * degree)) / 2) + 10 * (1 - (cos(20 * degree) + cos(60 * degree)) / 2))
  absorbed = (1 - rho) * pi / rho * integral
  printf "absorbed %g W of %g W, on %g m^2 of %g m^2\n", absorbed, power, area, whole
  balanced = absorbed > 0.99 * power && absorbed < 1.01 * power
  exit !(balanced && area > 0.999 * whole && area < 1.001 * whole)
}
END

awk -f "$STRAD_SOURCE_DIR/scenes/halls/solids.awk" -f boxes.awk >boxes.obj
strad-import boxes.obj | strad-motion boxes.motion | strad-solve -e 0.02 | strad-frame -f 1 --ply >boxes.ply
header=$(sed '/^end_header$/q' boxes.ply | tr -d '\0')
count=$(sed -n 's/^element vertex //p' <<<"$header")
tail -c +$((${#header} + 2)) boxes.ply >bytes
head -c $((27 * count)) bytes | od -An -v -tu1 -w27 >vertices
tail -c +$((27 * count + 1)) bytes | od -An -v -tu1 -w13 >triangles
awk -v whole="$(cat area)" -f integral.awk vertices triangles
