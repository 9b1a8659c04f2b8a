# A frame has the same bytes however many threads made it and whichever frames were made with it.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

strad-import $scene.obj | strad-motion $scene.motion | strad-solve -e 0.3 --time 2.2:2.6 >solved.strad
for direct in pixel mesh; do
  strad-frame -j 1 -s 40x40 --direct $direct -f 60:63 -o 'one.%04d.pfm' solved.strad
  strad-frame -j 3 -s 40x40 --direct $direct -f 60:63 -o 'three.%04d.pfm' solved.strad
  strad-frame -j 2 -s 40x40 --direct $direct -f 62 -o 'alone.%04d.pfm' solved.strad
  for k in 60 61 62 63; do cmp one.00$k.pfm three.00$k.pfm; done
  cmp one.0062.pfm alone.0062.pfm
  # The same bytes down a pipe, and of a stream that comes through a pipe.
  cat one.006[0-3].pfm >all.pfm
  strad-frame -s 40x40 --direct $direct -f 60:63 --pfm <solved.strad | cmp - all.pfm
  if cmp -s one.0060.pfm one.0062.pfm; then exit 1; fi  # the boxes have moved between the two
  for format in exr png; do
    strad-frame -j 1 -s 40x40 --direct $direct -f 60 -o one.%d.$format solved.strad
    strad-frame -j 3 -s 40x40 --direct $direct -f 60 -o three.%d.$format solved.strad
    cmp one.60.$format three.60.$format
  done
done
