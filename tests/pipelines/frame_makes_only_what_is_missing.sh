# --missing renders frames whose files are absent, cut off, or of another scene or other options, and leaves the others
# as they are; --stats says which. Slabs of frames meet where the next begins.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/lamp/lamp

strad-import -q $scene.obj | strad-motion -q $scene.motion >scene.strad # 300 frames at 25 per second
strad-solve -q -e 0.5 --frames 1:100 scene.strad >first.strad
strad-solve -q -e 0.5 --frames 101:300 scene.strad >second.strad
strad-join -q first.strad second.strad | strad-info --json >joined.json
grep -q '"begin s": 4' joined.json
grep -q '"end s": 12' joined.json
for bad in 0:5 5:4 1.5:3 7 1:301; do
  status=0
  strad-solve --frames $bad scene.strad >/dev/null 2>errors || status=$?
  [ $status = 2 ] && [ "$(wc -l <errors)" = 1 ] && grep -q '^strad-solve: --frames: ' errors
done

render() { strad-frame -q -s 24x18 -f 1:5 "$@"; }
kept() { sed -n 's/^  "kept": \([0-9]*\),$/\1/p' stats; }
for format in exr png; do
  render --missing --stats stats -o "$format.%d.$format" first.strad
  [ "$(kept)" = 0 ]
  rm $format.2.$format
  truncate -s 500 $format.4.$format
  render -o "whole.%d.$format" first.strad
  render --missing --stats stats -o "$format.%d.$format" first.strad
  [ "$(kept)" = 3 ]
  for n in 1 2 3 4 5; do cmp $format.$n.$format whole.$n.$format; done
  render --exposure 1 --missing --stats stats -o "$format.%d.$format" first.strad
  [ "$(kept)" = 0 ]
  render --exposure 1 --missing --stats stats -o "$format.%d.$format" first.strad
  [ "$(kept)" = 5 ]
done

# Layers in files of their own: a frame is kept only if all of its files are there.
layers() { render --layers combined,normal --missing --stats stats -o 'layer.%d.png' first.strad; }
layers
[ "$(kept)" = 0 ]
rm layer.normal.2.png
layers
[ "$(kept)" = 4 ]
[ -s layer.normal.2.png ]
layers
[ "$(kept)" = 5 ]

# The same command lines, but another scene: only the fingerprint tells.
sed 's/rate 25/rate 24/' $scene.motion >lamp.motion
cp $scene.obj $scene.mtl .
make_scene() { strad-import -q lamp.obj | strad-motion -q lamp.motion | strad-solve -q -e 0.5 --at 0 >still.strad; }
make_scene
strad-frame -q -s 24x18 --missing -o still.exr still.strad
sed -i 's/rate 24/rate 23/' lamp.motion
make_scene
strad-frame -q -s 24x18 --missing --stats stats -o still.exr still.strad
[ "$(kept)" = 0 ]

status=0
strad-frame --missing -o 'f.%d.ppm' first.strad 2>errors || status=$?
[ $status = 2 ] && grep -q '^strad-frame: --missing: expected' errors

# strad-diff says the same in lines and as JSON, and nothing with -q.
strad-diff --each exr.%d.exr whole.%d.exr >lines || true
grep -q '^whole.3.exr rel_rmse ' lines
strad-diff --each --json exr.%d.exr whole.%d.exr >json || true
[ "$(sed -n 's/^rel_rmse //p' lines | cut -c1-8)" = "$(sed -n 's/^  "rel_rmse": //p' json | cut -c1-8)" ]
grep -q '"file": "whole.3.exr"' json
status=0
strad-diff -q exr.%d.exr whole.%d.exr >out 2>errors || status=$?
[ $status = 1 ] && [ ! -s out ] && [ ! -s errors ]
