# EXR and PNG files tell other programs what they show: time, rate, camera, exposure, colours, and how they were made.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

strad-import -q $scene.obj | strad-motion $scene.motion | strad-solve -q -e 0.5 --at 2 >solved.strad
# The camera 2 m in front of the origin, looking at it along -z: z of the world is lowered by 2 in the camera's frame.
look='from 0 0 2 to 0 0 0 up 0 1 0 fov 90'
frame() { strad-frame -q -t 2 -s 32x16 --samples 1 --camera-at "$look" "$@" solved.strad; }

frame --exposure 1.5 -o a.exr
oiiotool --info -v a.exr >told
has() { grep -qF -e "$1" told || { echo "found no '$1' in"; cat told; exit 1; }; }
has 'half openexr'
has 'chromaticities: 0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329'
has 'framesPerSecond: 25/1'
has 'frame: 1'
has 'time: 2'
has 'exposure: 1.5'
has 'software: "strad-frame 0.1.0"'
has 'strad-solve 0.1.0 -e 0.5 --at 2'
has 'worldToCamera: 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1'
# 90 degrees high: at a depth of 1 m the picture is 2 m high and 4 m wide. x 1 / 2, y as it is, w = 2 - z.
has 'worldToNDC: 0.5, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, 2, 2'
has 'screenWindowWidth: 4'

frame --exposure 1.5 -o a.png
oiiotool --info -v a.png >told
has 'uint8 png'
has 'Software: "strad-frame 0.1.0"'
has 'framesPerSecond: "25"'
has 'exposure: "1.5"'
has 'strad-solve 0.1.0 -e 0.5 --at 2'
has 'ColorSpace: "sRGB"'
for chunk in sRGB gAMA cHRM; do grep -q $chunk a.png; done

# Numbers as they were asked for.
frame --exposure 1.5 -o a.pfm
for case in 'float exr 1e-7' '16 png 0.0001' '16 ppm 0.0001' '8 tif 0.01'; do
  read -r depth format most <<<"$case"
  frame --exposure 1.5 --white 20 --depth $depth -o b.$format 2>/dev/null || frame --exposure 1.5 --depth $depth -o b.$format
  white=20
  [ $format != exr ] || white=1
  oiiotool a.pfm --mulc $(awk "BEGIN { print 1 / $white }") -d float -o scaled.exr
  strad-diff scaled.exr b.$format --max $most >/dev/null || { echo "depth $depth of $format is off"; exit 1; }
done
oiiotool --info b.exr | grep -q 'float openexr'
oiiotool --info b.png | grep -q 'uint16 png'
oiiotool --info b.tif | grep -q 'uint8 tiff'

# Numbers in proportion to light are said to be so. Taken as light, they are what --tone srgb writes on its curve.
frame --depth 16 --tone linear -o linear.png
frame --depth 16 -o srgb.png
oiiotool --info -v linear.png | grep -q 'oiio:Gamma: 1'
oiiotool linear.png -d float -o linear.exr
strad-diff linear.exr srgb.png --max 0.0003 >/dev/null

# Exposure by the brightness of all the animation is the same for any frame of it, and brings it into the picture.
strad-import -q $scene.obj | strad-motion $scene.motion | strad-solve -q -e 0.5 --time 0:3 >slab.strad
for frame in 1 70; do
  strad-frame -q -f $frame -s 16x12 --samples 1 --exposure auto -o auto.exr slab.strad
  oiiotool --info -v auto.exr | grep ' exposure: ' >exposure.$frame
done
cmp exposure.1 exposure.70
if grep -q 'exposure: 0$' exposure.1; then exit 1; fi

refused() {  # refused TEXT ARGUMENTS...
  local status=0 text=$1
  shift
  frame "$@" >out 2>err || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF -e "$text" err || [ -s out ]; then
    echo "strad-frame $*: exit status $status, expected 2 and: $text"
    cat err
    exit 1
  fi
}
refused "--depth: found 'half', expected 8 or 16 for png" --depth half -o x.png
refused "--depth: found '8', expected half or float for exr" --depth 8 -o x.exr
refused "--depth: found 'float', expected 8 or 16 for ppm" --depth float
refused '--tone: found pictures of floats (exr)' --tone filmic -o x.exr
refused '--white: found pictures of floats (pfm)' --white 2 --pfm
refused '--white: expected a radiance above 0' --white 0
refused '--exposure: found' --exposure bright
refused '--exposure auto: for pictures of the solution' --exposure auto --reference 1
refused '--show and --tone: found both' --show elements --tone filmic
[ ! -e x.png ] && [ ! -e x.exr ]
