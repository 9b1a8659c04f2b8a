# The page of `make paper` has all tables and figures of the paper, is well-formed and refers to nothing outside itself.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

export PAPER_SCENES='swing shutter' PAPER_ERROR=0.5 PAPER_INSTANTS=1 PAPER_SIZE=32x24 PAPER_POINT=0,0,0,0,0,1
bash "$STRAD_SOURCE_DIR/tests/paper/paper.sh" page 2>log || { cat log; exit 1; }
page=page/index.html

expect() {  # expect NAME FOUND EXPECTED
  [ "$2" = "$3" ] || { echo "$1: found $2, expected $3"; exit 1; }
}

for part in table-1 table-2 figure-2 figure-3 figure-4 figure-5; do
  expect $part "$(grep -c "id=\"$part\"" $page)" 1
done
# Figure 2: two bases, three pictures each. Figure 3: two plots. Figure 4: three bases on each scene, and one without
# clusters. Figure 5: six frames of each scene.
expect pictures "$(grep -c '<img ' $page)" $((2 * 3 + 2 + 2 * 3 + 1 + 2 * 6))
expect "pictures in the page" "$(grep -cE '<img .*src="data:image/(png|svg\+xml);base64,[A-Za-z0-9+/=]{200,}"/>$' $page)" "$(grep -c '<img ' $page)"
expect "references to the outside" "$(sed 's/base64,[^"]*//' $page | grep -ciE '//|href|url\(|<script|<link|@import' || true)" 0

# Tables hold the paper's figures and ours: all are numbers in the row of M2, and the acceleration of the paper is 5.5.
expect "figures of M2" "$(grep -cE '^<tr><th>M2</th>(<td>[0-9.e-]+</td>){12}</tr>$' $page)" 2
expect "acceleration in the paper" "$(grep -c '<td>587</td><td>5.5</td>' $page)" 1

# Every element is closed, in the order of their opening.
awk 'BEGIN { RS = "<" }
  NR == 1 || /^!DOCTYPE/ { next }
  {
    tag = $0
    sub(/>.*/, "", tag)
    name = tag
    sub(/[ \n\/].*/, "", name)
    if (tag ~ /^\//) {
      name = substr(tag, 2)
      if (open[depth--] != name) { print "</" name "> closes <" open[depth + 1] ">"; exit 1 }
    } else if (tag !~ /\/$/) open[++depth] = name
  }
  END { if (depth) { print "<" open[depth] "> is not closed"; exit 1 } }' $page
