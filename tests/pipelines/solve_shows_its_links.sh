# strad-solve --links: a PLY mesh, the same for any number of threads; the stream does not change by it.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

strad-import $scene.obj | strad-motion $scene.motion >scene.strad
strad-solve -j 1 -e 0.5 --at 2 scene.strad >plain.strad
strad-solve -j 1 -e 0.5 --at 2 --links one.ply scene.strad | cmp - plain.strad
strad-solve -j 3 -e 0.5 --at 2 --links three.ply -o solved.strad scene.strad
cmp one.ply three.ply
cmp solved.strad plain.strad

# 15 bytes a corner; a face takes 5 bytes and 4 a corner. At an instant no link changes, so the sum over faces of links
# is at least the number of links that strad-info tells, for each arrives at one leaf or more.
vertices=$(grep -a '^element vertex ' one.ply | cut -d' ' -f3)
faces=$(grep -a '^element face ' one.ply | cut -d' ' -f3)
header=$(grep -a -b '^end_header$' one.ply | cut -d: -f1)
[ "$(wc -c <one.ply)" = $((header + 11 + 15 * vertices + 5 * faces + 4 * vertices)) ]
links=$(strad-info solved.strad | sed -nE 's/.*links:? +([0-9]+).*/\1/p' | head -1)
tail -c $((5 * faces + 4 * vertices)) one.ply | od -An -v -tu1 -w1 | awk -v told="$links" '
  { b[NR] = $1 }
  END {
    for (i = 1; i <= NR; i += 5 + 4 * n) {
      n = b[i]
      k = i + 1 + 4 * n
      sum += b[k] + 256 * b[k + 1] + 65536 * b[k + 2]
    }
    print sum " arrive, " told " links"
    exit !(told > 0 && sum >= told)
  }'

status=0
strad-solve -e 0.5 --at 2 --links no/such/folder.ply -o out.strad scene.strad 2>stderr || status=$?
[ $status = 2 ]
[ "$(wc -l <stderr)" = 1 ]
