# -o FILE: the file appears whole or not at all, what it held before stays until then, and nothing is left beside it.
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

# Whole where it succeeds, in place of what was there.
strad-motion $scene.motion scene.strad -o out/a.strad
strad-info out/a.strad >/dev/null
test "$(ls -A out)" = a.strad
