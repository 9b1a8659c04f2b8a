# -o FILE: the file appears complete or not at all, what it held before stays until then, and nothing is left beside it.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/room4/room4

strad-import $scene.obj -o scene.strad
strad-motion $scene.motion scene.strad -o moving.strad
head -c 1000 moving.strad >broken.strad
mkdir out

fails() {
  local status=0
  "$@" 2>err || status=$?
  test $status = 2 || { echo "$*: exit status $status"; exit 1; }
  test "$(wc -l <err)" = 1 || { cat err; exit 1; }
}
fails strad-motion $scene.motion broken.strad -o out/a.strad
fails strad-solve broken.strad -o out/a.strad
fails strad-info broken.strad -o out/a.txt
fails strad-join moving.strad -o out/a.strad
fails strad-frame -f 1 -o out/a.png moving.strad  # no solution in it
fails strad-import missing.obj -o out/a.strad
fails strad-import $scene.obj -o out/no/such/folder.strad
test -z "$(ls -A out)"

# Interrupted in the middle of its work.
echo before >out/a.strad
strad-solve -e 0.001 moving.strad -o out/a.strad &
sleep 0.5
kill $!
if wait $!; then exit 1; fi
test "$(cat out/a.strad)" = before
test "$(ls -A out)" = a.strad

# Frames that are there when it is interrupted are complete: 40 x 40 pixels of 12 bytes after the header.
shutter=$STRAD_SOURCE_DIR/scenes/shutter/shutter
strad-import $shutter.obj | strad-motion $shutter.motion | strad-solve -e 0.2 -o shutter.strad
mkdir frames
header='PF 40 40 -1.0 '
strad-frame -s 40x40 -f 1:600 -o frames/%d.pfm shutter.strad &
while [ ! -e frames/2.pfm ] && kill -0 $!; do sleep 0.01; done
kill $!
if wait $!; then exit 1; fi
test "$(ls frames | wc -l)" -lt 600
test -z "$(find frames -name '.*' -type f)"
for file in frames/*.pfm; do
  test "$(stat -c %s $file)" = $((12 * 40 * 40 + ${#header}))
done

# A disk that is full, or as here a limit of a kilobyte: one line that names the file, and nothing is left. 100 x 100
# pixels of light with edges are more than that in every format.
mkdir full
strad-motion $scene.motion scene.strad | strad-solve -e 0.5 -o room.strad
limited() { bash -c 'ulimit -f 1; exec "$@"' limited "$@"; }
for format in jpg png exr tif bmp ppm pfm sgi tga; do
  fails limited strad-frame -f 1 -s 100x100 -o full/a.$format room.strad
  grep -q "^strad-frame: full/a.$format: cannot be written: " err || { cat err; exit 1; }
done
fails limited strad-solve -e 0.5 moving.strad -o full/a.strad
fails limited strad-frame --ply -f 1 -o full/a.ply room.strad
test -z "$(ls -A full)"
fails limited strad-frame --pov -f 1 -o full/a.inc room.strad  # of several files, of which some are small enough
test ! -e full/a.inc && test -z "$(find full -name '.*' -type f)"

# If it succeeds, the complete file replaces what was there.
strad-motion $scene.motion scene.strad -o out/a.strad
strad-info out/a.strad >/dev/null
test "$(ls -A out)" = a.strad
