# The lines of strad(5) for file(1) recognise a stream and tell its version.
command -v file >/dev/null || { echo "file(1) is not installed"; exit 0; }
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
sed -n '/lines for file(1)/,/^\.Ed/p' "$STRAD_SOURCE_DIR/man/strad.5" | grep -v '^\.' |
  sed 's/\\e/\\/g' >magic
test "$(wc -l <magic)" = 3
strad-import "$STRAD_SOURCE_DIR/scenes/shutter/shutter.obj" >a.strad
test "$(file -b -m magic a.strad)" = 'strad stream, version 1'
test "$(file -b -i -m magic a.strad)" = 'application/x-strad; charset=binary'
head -c 7 a.strad >cut
! file -b -m magic cut | grep -q strad
