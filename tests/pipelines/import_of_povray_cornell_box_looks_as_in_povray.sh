# POV-Ray's own Cornell box, imported and solved, has the light that POV-Ray's radiosity gives it.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# A narrower view leaves out the lamp, which POV-Ray draws by its looks alone.
sed 's/angle 39.5/angle 25/; s/recursion_limit 3/recursion_limit 8/' "$STRAD_SOURCE_DIR/tests/data/models/povray-examples/cornell.pov" > cornell.pov
strad-import -v -o cornell.strad cornell.pov 2> notes
grep -qx 'strad-import: 39 polygons, 14 objects, 4 materials' notes
grep -q 'cornell.pov:70: glowing surface without shadow left out' notes
strad-solve -q -e 0.05 -o solved.strad cornell.strad
strad-frame -q -s 96x96 -o strad.exr solved.strad
povray +Icornell.pov +W96 +H96 +A0.1 -D +FE +Opovray.exr > povray.log 2>&1
# What is left: POV-Ray's estimate of indirect light, and its fading near the lamp, 1 / (1 + r^2 / d^2). Its lights are four by four points.
strad-diff --rel-rmse 0.08 strad.exr povray.exr
