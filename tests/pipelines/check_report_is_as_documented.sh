# The report of strad-check: text, JSON, cameras, worst places for strad-probe; the same bytes for any number of threads
# and from a pipe; one line and status 2 where there is nothing to check.
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

strad-import $scene.obj | strad-motion $scene.motion >scene.strad
strad-solve -e 0.5 --time 1:3 scene.strad >solved.strad
check() { strad-check --points 300 --paths 128 "$@" solved.strad; }

for of in '' '--direct mesh' '-c main -s 160x160' '-t 1.5:2' '--json'; do
  check -j 1 $of >one
  check -j 2 $of >two
  cmp one two
done
check >text
strad-check --points 300 --paths 128 <solved.strad | cmp - text
check --seed 1 >other
if cmp -s text other; then exit 1; fi
check -c main >camera
if cmp -s text camera; then exit 1; fi
check -o file
cmp text file

# Four tables; the points of each are all that count, the shares of each add up to all.
awk '
  $1 == "mean" { all = $6 }
  / by / { table = $NF; tables++; next }
  NF == 0 { table = "" }
  table != "" { points[table] += $8; share[table] += $7 }
  END {
    for (table in points) if (points[table] != all || (share[table] - 100)^2 > 1) { print table, points[table], share[table]; exit 1 }
    exit tables != 4
  }' text || { cat text; exit 1; }
for body in world tall short; do grep -q " $body\$" text; done

# The same error in JSON, as a fraction.
check --json >json
text_error=$(awk '$1 == "error" { print $2 }' text)
awk -v want="$text_error" '/"rel_rmse"/ { getline; gsub(",", ""); exit !((100 * $2 - want)^2 < 1e-4) }' json
for name in body material brightness time worst; do grep -q "^  \"$name\": \[" json; done

# strad-probe finds each of the worst places on the object that is named there.
check --direct mesh >mesh
grep '#' mesh >worst
[ "$(wc -l <worst)" = 10 ]
strad-probe -n 1 --points worst solved.strad | tail -n +2 | cut -f 3 >objects
sed 's/.* on //' worst | cmp - objects

refused() { # expected text, arguments
  local status=0 text=$1
  shift
  strad-check "$@" >stdout 2>stderr || status=$?
  if [ $status != 2 ] || [ "$(wc -l <stderr)" != 1 ] || ! grep -q "^strad-check: .*$text" stderr || [ -s stdout ]; then
    echo "$*: exit status $status"
    cat stderr
    exit 1
  fi
}
refused 'no solution' scene.strad
refused 'expected one of main' -c side solved.strad
refused 'for --camera only' -s 10x10 solved.strad
refused '1 to 1000000' --points 0 solved.strad
refused '1 to 10000000' --paths 0 solved.strad
refused 'A:B' -t 2 solved.strad
refused 'A <= B' -t 2:1 solved.strad
refused 'the solution' -t 0:2 solved.strad
refused 'limit' --limit -1 solved.strad
