# The generator of halls keeps its word: N polygons, no more bytes than once, parts that move.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
halls=$STRAD_SOURCE_DIR/scenes/halls/halls.sh

for n in 1000 1234 9999 30000; do
  "$halls" $n a/halls
  [ "$(grep -c '^f ' a/halls/halls.obj)" = $n ]
  strad-import a/halls/halls.obj | strad-motion a/halls/halls.motion | strad-info >info
  grep -q "polygons: $n\$" info
  grep -q 'h0_rotor' info
done
"$halls" 30000 b/halls
diff -r a b

for bad in '' 0 999 12x 0x400 1e4; do
  status=0
  "$halls" "$bad" c 2>err || status=$?
  [ $status = 2 ]
  [ "$(wc -l <err)" = 1 ]
  [ ! -e c ]
done
