# The generator of the complex room keeps its word: N polygons or some dozen fewer, no more bytes than once, all that
# stands in the room closed and outward, two models that move besides what moves in room4.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
complex=$STRAD_SOURCE_DIR/scenes/complex/complex.sh

for n in 5000 5678 30000; do
  "$complex" $n a/complex
  strad-import a/complex/complex.obj | strad-motion a/complex/complex.motion | strad-info >info
  awk -v n=$n '$1 == "polygons:" { exit !($2 > n - 60 && $2 <= n) }' info
  grep -q 'name knot, on world, objects 1' info
  grep -q 'name machine, on world, objects 1' info
  [ "$(sed -n '/spots:/,/glows:/p' info | grep -c name)" = 4 ]
done

# Every edge of a closed solid is there once each way; six times its volume is the sum of det(a, b, c) over triangles.
cat >closed.awk <<'END'
$1 == "v" { x[++v] = $2; y[v] = $3; z[v] = $4 }
$1 == "o" { object = $2; solid = !(object ~ /^(floor|ceiling|wall_.*|cart)$/) }
$1 == "f" && solid {
  for (i = 2; i <= NF; ++i) { a = $i; b = i < NF ? $(i + 1) : $2; ++edges[a "," b]; ++all }
  for (i = 3; i < NF; ++i) volume[object] += det($2, $i, $(i + 1)) / 6
}
function det(a, b, c) {
  return x[a] * (y[b] * z[c] - z[b] * y[c]) + y[a] * (z[b] * x[c] - x[b] * z[c]) + z[a] * (x[b] * y[c] - y[b] * x[c])
}
END {
  for (edge in edges) { split(edge, e, ","); if (edges[edge] != 1 || edges[e[2] "," e[1]] != 1) ++open }
  for (object in volume) { ++solids; if (!(volume[object] > 0.005)) { print object " has a volume of " volume[object]; ++wrong } }
  print open + 0 " open edges of " all ", " solids " solids"
  exit open > 0 || wrong > 0 || solids != 7 || all < 90000
}
END
awk -f closed.awk a/complex/complex.obj
"$complex" 30000 b/complex
diff -r a b

for bad in '' 4999 12x 1e5; do
  status=0
  "$complex" "$bad" c 2>err || status=$?
  [ $status = 2 ]
  [ "$(wc -l <err)" = 1 ]
  [ ! -e c ]
done
