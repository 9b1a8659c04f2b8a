#!/bin/bash
# Blender exports a small animation as glTF and as numbered OBJ files; both are imported, solved, and their frames compared.
#
#   blender_export.sh        needs Blender (Debian: apt-get install blender; some 500 MB, runs without a screen), and numpy,
#                            which Blender's glTF exporter wants (python3-numpy)
#   KEEP=FOLDER              keep what Blender wrote and the frames
#
# A room with a lamp of emitting polygons, a box that slides and a box that turns about the vertical, 25 frames at 25 a
# second. Prints, frame by frame, the relative RMSE between the two ways, and fails above LIMIT (0.03): the two streams have
# the same surfaces, but different bodies and keys, and so different noise.
set -eu -o pipefail
export LC_ALL=C
command -v blender >/dev/null || { echo "blender is missing; Debian has it in blender" >&2; exit 2; }
work=${KEEP:-$(mktemp -d)}
[ -n "${KEEP:-}" ] || trap 'rm -rf "$work"' EXIT
mkdir -p "$work"

cat >"$work/scene.py" <<'END'
import bpy, math, sys
folder = sys.argv[-1]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.fps = 25
scene.frame_start, scene.frame_end = 1, 25

def material(name, colour, emission=None):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = made.node_tree.nodes
    shader = nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    if emission:
        shader.inputs["Emission"].default_value = (*emission, 1)
        shader.inputs["Emission Strength"].default_value = 1
    return made

def box(name, at, size, of, inwards=False):
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 0))
    made = bpy.context.object
    made.name = name
    for vertex in made.data.vertices:
        vertex.co = [c * s for c, s in zip(vertex.co, size)]
    if inwards:
        made.data.flip_normals()
    made.location = at
    made.data.materials.append(of)
    return made

white = material("white", (0.7, 0.7, 0.7))
box("room", (0, 0, 1.5), (4, 4, 3), white, inwards=True)
bpy.ops.mesh.primitive_plane_add(size=1, location=(0, 0, 2.99), rotation=(math.pi, 0, 0))
lamp = bpy.context.object
lamp.name = "lamp"
lamp.data.materials.append(material("lamp", (0, 0, 0), (1, 0.9, 0.8)))
slider = box("slider", (-1, 0.5, 0.5), (0.6, 0.6, 0.6), material("red", (0.7, 0.2, 0.2)))
turner = box("turner", (0.8, 0, 0.6), (0.8, 0.4, 1.0), material("blue", (0.2, 0.3, 0.7)))
for frame in range(1, 26):
    slider.location.x = -1 + frame / 25
    turner.rotation_euler.z = math.radians(3.6 * frame)
    slider.keyframe_insert("location", frame=frame)
    turner.keyframe_insert("rotation_euler", frame=frame)

bpy.ops.export_scene.gltf(filepath=folder + "/blender.glb", export_format="GLB", export_yup=True)
bpy.ops.wm.obj_export(filepath=folder + "/blender.obj", export_animation=True, start_frame=1, end_frame=25,
                      forward_axis="NEGATIVE_Z", up_axis="Y", export_triangulated_mesh=False)
END
blender --background --factory-startup --python "$work/scene.py" -- "$work" >"$work/log" 2>&1 ||
  { tail -20 "$work/log" >&2; exit 1; }
# Blender's names: blender0001.obj, or blender1.obj in some versions.
ls "$work"/blender*.obj >"$work/names"
pattern=$(head -1 "$work/names" | sed -E 's/0*1\.obj$//')
digits=$(head -1 "$work/names" | sed -E 's/.*[^0-9]([0-9]+)\.obj$/\1/' | tr -d '\n' | wc -c)
name="$pattern%0${digits}d.obj"

camera='from 1.8 1.6 1.8 to 0 0.8 0 fov 70'
strad-import -q "$work/blender.glb" | strad-solve -q >"$work/gltf.strad"
strad-import -q -f 1:25 --rate 25 --light 'lamp*=1,0.9,0.8' "$name" | strad-solve -q >"$work/obj.strad"
for way in gltf obj; do
  strad-frame -q -f 1,9,17,25 -s 160x120 --camera-at "$camera" -o "$work/$way.%02d.exr" "$work/$way.strad"
done
strad-diff -f 1,9,17,25 --rel-rmse "${LIMIT:-0.03}" "$work/gltf.%02d.exr" "$work/obj.%02d.exr"
