# The table of strad-probe: header, order of rows, number of instants, names, points from options and files.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

cat >room.obj <<'END'
mtllib room.mtl
v 0 0 0
v 4 0 0
v 4 4 0
v 0 4 0
v 0 0 2
v 4 0 2
v 4 4 2
v 0 4 2
o low floor
usemtl grey
f 1 2 3 4
o top
usemtl lamp
f 5 8 7 6
END
printf 'newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 2 3\n' >room.mtl
printf 'time 1 2\nrate 10\nglow lamp\n  key 1 value 1\n  key 2 value 3\n' >room.motion
strad-import room.obj | strad-motion room.motion | strad-solve -e 0.05 >room.strad

printf '# points\n2 2 1.9\n\n0.5,0.5,0 0 0 1\n' >points
strad-probe --at 2,2,0 --points points -n 3 room.strad >table
[ "$(head -1 table)" = "$(printf 'time\tpoint\tobject\tr\tg\tb\ter\teg\teb')" ]
[ "$(tail -n +2 table | cut -f 1,2 | tr '\t\n' ': ')" = "1:0 1:1 1:2 1.5:0 1.5:1 1.5:2 2:0 2:1 2:2 " ]
awk -F '\t' 'NF != 9 { exit 1 }' table
[ "$(awk -F '\t' '$2 == 1 { print $3; exit }' table)" = top ]

# The floor is lit by the ceiling alone: twice the glow, twice the light; E = pi L / rho.
awk -F '\t' '$2 == 0 && NR > 1 {
  if ($1 == 1) for (c = 4; c <= 9; ++c) first[c] = $c
  for (c = 4; c <= 9; ++c) if (($c / first[c] - (1 + 2 * ($1 - 1)))^2 > 1e-4) { print; exit 1 }
  for (c = 4; c <= 6; ++c) if (($(c + 3) * 0.5 / 3.14159265 / $c - 1)^2 > 1e-10) { print; exit 1 }
}' table
# The lamp shows its own light on its front and none on its back.
strad-probe --at 2,2,2 -n 1 room.strad | awk 'NR == 2 && !($4 == 1 && $5 == 2 && $6 == 3) { print; exit 1 }'
strad-probe --at 2,2,2,0,0,1 -n 1 room.strad | awk 'NR == 2 && !($4 == 0) { print; exit 1 }'

[ "$(strad-probe --at 2,2,0 room.strad | wc -l)" = 102 ]
[ "$(strad-probe --at 2,2,0 --frames room.strad | tail -1 | cut -f 1)" = 2 ] ||
  [ "$(strad-probe --at 2,2,0 --frames room.strad | tail -1 | cut -f 1)" = 1.9 ]
strad-probe -j 1 --at 2,2,0 --points points -n 9 room.strad >one
strad-probe -j 2 --at 2,2,0 --points points -n 9 <room.strad | cmp - one

refused() { # expected text, arguments
  local status=0 text=$1
  shift
  strad-probe "$@" room.strad >stdout 2>stderr || status=$?
  if [ $status != 2 ] || [ "$(wc -l <stderr)" != 1 ] || ! grep -q "$text" stderr || [ -s stdout ]; then
    echo "$*: exit status $status"
    cat stderr
    exit 1
  fi
}
refused '^strad-probe: found no points'
refused "^strad-probe: --at: found 2 numbers, expected X,Y,Z or X,Y,Z,NX,NY,NZ" --at 1,2
refused "found 'x'" --at 1,2,x
refused 'length 0' --at 1,2,3,0,0,0
refused 'found both' --at 1,2,3 -n 5 --frames
refused 'expected 1 to' --at 1,2,3 -n 0
refused 'missing' --points missing
echo '1 2 3 4' >bad
refused '^strad-probe: bad:1: found 4 numbers' --points bad
