# One model, an OBJ file or a mesh2 of POV-Ray's, as an object that stands on the point x, y, z. Variables: name, the
# object's; x, y, z; size, its largest extent along an axis, m; turn about the upright, degrees; up, `y` or `z`, the
# model's upright axis; colour, of what the model gives no material that `palette` (an MTL file) has.

BEGIN {
  if (palette) while ((getline <palette) > 0) { sub(/\r$/, ""); if ($1 == "newmtl") known[plain($2)] = 1 }
}

# Names in ASCII: models have any.
function plain(text) { gsub(/[^-A-Za-z0-9_]/, "_", text); return text }

{ sub(/\r$/, "") }

$1 == "v" { point($2, $3, $4) }
$1 == "usemtl" { material = plain($2) }
$1 == "f" {
  face = ""
  for (i = 2; i <= NF; ++i) { split($i, index_of, "/"); face = face " " index_of[1] }
  keep(face)
}

# POV-Ray's space is left-handed: z is turned round, which keeps what is outward outward. Indices count from 0.
$1 ~ /_vectors$|_indices$|_list$/ { section = $1 }
section == "vertex_vectors" || section == "face_indices" {
  n = split($0, part, "<")
  for (i = 2; i <= n; ++i) {
    split(part[i], number, /[,>]/)
    if (section == "vertex_vectors") point(number[1], number[2], -number[3])
    else keep((number[1] + 1) " " (number[2] + 1) " " (number[3] + 1))
  }
}

function point(a, b, c) {
  ++points
  px[points] = a + 0; py[points] = (up == "z" ? b : -c) + 0; pz[points] = (up == "z" ? c : b) + 0
  if (points == 1) { low_x = high_x = px[1]; low_y = high_y = py[1]; low_z = high_z = pz[1] }
  if (px[points] < low_x) low_x = px[points]; if (px[points] > high_x) high_x = px[points]
  if (py[points] < low_y) low_y = py[points]; if (py[points] > high_y) high_y = py[points]
  if (pz[points] < low_z) low_z = pz[points]; if (pz[points] > high_z) high_z = pz[points]
}

function keep(indices) {
  faces[++count] = indices
  paint[count] = (palette && material in known) ? name "_" material : colour
}

END {
  if (!count) { print "models: no faces in " FILENAME >"/dev/stderr"; exit 2 }
  extent = high_x - low_x
  if (high_y - low_y > extent) extent = high_y - low_y
  if (high_z - low_z > extent) extent = high_z - low_z
  scale = size / extent; angle = turn * atan2(0, -1) / 180
  print "o " name
  for (i = 1; i <= points; ++i) {
    a = scale * (px[i] - (low_x + high_x) / 2); b = scale * (py[i] - (low_y + high_y) / 2)
    printf "v %.6f %.6f %.6f\n", x + a * cos(angle) - b * sin(angle), y + a * sin(angle) + b * cos(angle), z + scale * (pz[i] - low_z)
  }
  for (i = 1; i <= count; ++i) {
    if (paint[i] != painted) print "usemtl " (painted = paint[i])
    n = split(faces[i], corner, " ")
    line = "f"
    for (k = 1; k <= n; ++k) line = line " " corner[k] - points - 1
    print line
  }
}
