# An orrery in a room, as the JSON of a glTF file on standard output and its numbers as octal escapes of bytes in the file `bin`.
# The arm turns by 270 degrees in 4 s (LINEAR quaternions a third of it apart), the planet on it goes up and down (CUBICSPLINE),
# its moon turns about it against the arm, a flag on the wall jumps up at 2 s (STEP), the camera moves; a spotlight rides on the
# planet.
function byte(n) { printf "\\%03o", n >bin; ++size }
function f32(x,   sign, e, m, i, bits) {  # IEEE 754, for numbers that are not tiny
  sign = x < 0; if (sign) x = -x
  if (x == 0) { byte(0); byte(0); byte(0); byte(0); return }
  e = 0
  while (x >= 2) { x /= 2; ++e }
  while (x < 1) { x *= 2; --e }
  m = int((x - 1) * 8388608 + 0.5)
  if (m == 8388608) { m = 0; ++e }
  e += 127
  byte(m % 256); byte(int(m / 256) % 256); byte(int(m / 65536) + (e % 2) * 128); byte(int(e / 2) + sign * 128)
}
function accessor(list, type, width, component, count,   n, i, parts, at) {
  at = size + 0
  n = split(list, parts, " ")
  for (i = 1; i <= n; ++i)
    if (component == 5126) f32(parts[i] + 0)
    else { byte(parts[i] % 256); byte(int(parts[i] / 256)) }
  views = views (count_of ? "," : "") "{\"buffer\":0,\"byteOffset\":" at ",\"byteLength\":" (size - at) "}"
  accessors = accessors (count_of ? "," : "") "{\"bufferView\":" count_of + 0 ",\"componentType\":" component \
              ",\"count\":" n / width ",\"type\":\"" type "\"" (type == "VEC3" && limits ? limits : "") "}"
  while (size % 4) byte(0)
  return count_of++
}
function floats(list, type, width) { return accessor(list, type, width, 5126) }
function shorts(list) { return accessor(list, "SCALAR", 1, 5123) }
function sampler(times, values, way) {
  samplers = samplers (sampler_count ? "," : "") "{\"input\":" times ",\"output\":" values ",\"interpolation\":\"" way "\"}"
  return sampler_count++
}
function channel(node, path, times, values, way,   s) {
  s = sampler(times, values, way)
  channels = channels (channel_count++ ? "," : "") "{\"sampler\":" s ",\"target\":{\"node\":" node ",\"path\":\"" path "\"}}"
}
function mesh(name, points, corners, material) {
  meshes = meshes (mesh_count ? "," : "") "{\"name\":\"" name "\",\"primitives\":[{\"attributes\":{\"POSITION\":" points \
           "},\"indices\":" corners ",\"material\":" material "}]}"
  return mesh_count++
}
function node(text) { nodes = nodes (node_count ? "," : "") "{" text "}"; return node_count++ }
function material(name, r, g, b, more) {
  materials = materials (material_count ? "," : "") "{\"name\":\"" name "\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[" \
              r "," g "," b ",1],\"metallicFactor\":0}" more "}"
  return material_count++
}
BEGIN {
  pi = atan2(0, -1)
  plaster = material("plaster", 0.7, 0.68, 0.62)
  brass = material("brass", 0.6, 0.45, 0.2)
  lamp = material("lamp", 0.5, 0.5, 0.5, ",\"emissiveFactor\":[1,0.92,0.75]," \
         "\"extensions\":{\"KHR_materials_emissive_strength\":{\"emissiveStrength\":10}}")
  limits = ",\"min\":[-1,-1,-1],\"max\":[1,1,1]"
  cube = floats("-1 -1 -1 1 -1 -1 1 1 -1 -1 1 -1 -1 -1 1 1 -1 1 1 1 1 -1 1 1", "VEC3", 3)
  limits = ""
  out = shorts("0 3 2 0 2 1 4 5 6 4 6 7 0 1 5 0 5 4 3 7 6 3 6 2 0 4 7 0 7 3 1 2 6 1 6 5")
  inward = shorts("0 2 3 0 1 2 4 6 5 4 7 6 0 5 1 0 4 5 3 6 7 3 2 6 0 7 4 0 3 7 1 6 2 1 5 6")
  limits = ",\"min\":[-0.6,0,-0.6],\"max\":[0.6,0,0.6]"
  square = floats("-0.6 0 -0.6 0.6 0 -0.6 0.6 0 0.6 -0.6 0 0.6", "VEC3", 3)
  limits = ""
  down = shorts("0 1 2 0 2 3")
  room_mesh = mesh("room", cube, inward, plaster)
  cube_mesh = mesh("cube", cube, out, brass)
  lamp_mesh = mesh("lamp", square, down, lamp)

  node("\"name\":\"room\",\"mesh\":" room_mesh ",\"translation\":[0,1.5,0],\"scale\":[3,1.5,3]")
  node("\"name\":\"lamp\",\"mesh\":" lamp_mesh ",\"translation\":[0,2.99,0]")
  node("\"name\":\"pillar\",\"mesh\":" cube_mesh ",\"translation\":[0,0.5,0],\"scale\":[0.1,0.5,0.1]")
  arm = node("\"name\":\"arm\",\"translation\":[0,1.05,0],\"children\":[4,5]")
  node("\"name\":\"beam\",\"mesh\":" cube_mesh ",\"translation\":[0.7,0,0],\"scale\":[0.8,0.05,0.08]")
  planet = node("\"name\":\"planet\",\"translation\":[1.5,0.3,0],\"children\":[6,7,8]")
  node("\"name\":\"globe\",\"mesh\":" cube_mesh ",\"scale\":[-0.2,0.2,0.2]")
  moon = node("\"name\":\"moon axis\",\"children\":[9]")
  node("\"name\":\"torch\",\"translation\":[0,0,0.25],\"rotation\":[0,1,0,0],\"extensions\":{\"KHR_lights_punctual\":{\"light\":0}}")
  node("\"name\":\"moon\",\"mesh\":" cube_mesh ",\"translation\":[0.45,0,0],\"scale\":[0.07,0.07,0.07]")
  flag = node("\"name\":\"flag\",\"mesh\":" cube_mesh ",\"translation\":[-2.9,1,0],\"scale\":[0.05,0.2,0.3]")
  eye = node("\"name\":\"main\",\"translation\":[0.5,1.7,2.8],\"rotation\":[-0.08715574,0,0,0.9961947],\"camera\":0")

  quarter = floats("0 1.3333334 2.6666667 4", "SCALAR", 1)
  turns = ""
  for (i = 0; i <= 3; ++i) turns = turns " 0 " sin(i * pi / 4) " 0 " cos(i * pi / 4)
  channel(arm, "rotation", quarter, floats(turns, "VEC4", 4), "LINEAR")
  third = floats("0 2 4", "SCALAR", 1)
  channel(planet, "translation", third, floats("0 0 0 1.5 0.3 0 0 0 0 0 0 0 1.5 0.7 0 0 0 0 0 0 0 1.5 0.3 0 0 0 0", "VEC3", 3), "CUBICSPLINE")
  back = ""
  for (i = 0; i <= 3; ++i) back = back " 0 " sin(-i * pi / 3) " 0 " cos(-i * pi / 3)
  channel(moon, "rotation", quarter, floats(back, "VEC4", 4), "LINEAR")
  channel(flag, "translation", third, floats("-2.9 1 0 -2.9 2 0 -2.9 2 0", "VEC3", 3), "STEP")
  ends = floats("0 4", "SCALAR", 1)
  channel(eye, "translation", ends, floats("0.5 1.7 2.8 -0.5 1.7 2.8", "VEC3", 3), "LINEAR")

  printf "{\"asset\":{\"version\":\"2.0\",\"generator\":\"orrery.awk\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,1,2,3,%d,%d]}],", flag, eye
  printf "\"extensionsUsed\":[\"KHR_lights_punctual\",\"KHR_materials_emissive_strength\"],"
  printf "\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[{\"name\":\"torch\",\"type\":\"spot\",\"color\":[1,0.9,0.7],\"intensity\":3415,"
  printf "\"spot\":{\"innerConeAngle\":0.2,\"outerConeAngle\":0.4}}]}},"
  printf "\"cameras\":[{\"type\":\"perspective\",\"perspective\":{\"yfov\":1.0471976,\"znear\":0.1}}],"
  printf "\"nodes\":[%s],\"meshes\":[%s],\"materials\":[%s],", nodes, meshes, materials
  printf "\"animations\":[{\"name\":\"run\",\"samplers\":[%s],\"channels\":[%s]}],", samplers, channels
  printf "\"buffers\":[{\"byteLength\":%d}],\"bufferViews\":[%s],\"accessors\":[%s]}", size, views, accessors
}
