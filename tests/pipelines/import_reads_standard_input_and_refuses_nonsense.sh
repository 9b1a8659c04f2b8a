# OBJ text comes down a pipe; directories, wrong options and terminals are refused with status 2 and one line.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

printf 'newmtl lamp\nKd 0.5 0.5 0.5\n' > m.mtl
printf 'mtllib m.mtl\nusemtl lamp\nv 0 0 0\nv 1 0 0\nv 1 0 -1\nf 1 2 3\n' > room.obj
strad-import -o file.strad room.obj
strad-import < room.obj > redirected.strad
cat room.obj | strad-import | cmp - redirected.strad
[[ $(strad-import -v - < room.obj 2>&1 > dash.strad) == 'strad-import: 1 polygons, 1 objects, 1 materials' ]]

refused() {  # expected line, then the arguments
  local expected=$1 status=0
  shift
  strad-import -o out.strad "$@" 2> err || status=$?
  [[ $status == 2 && ! -e out.strad && $(wc -l < err) == 1 ]]
  grep -qF -- "$expected" err || { cat err >&2; exit 1; }
}
refused 'is a directory, expected a text file' .
refused 'none.obj: cannot be opened' none.obj
refused '--light lamp: expected NAME=R,G,B' --light lamp room.obj
refused 'expected a radiance of 0 or more' --light lamp=-1,0,0 room.obj
refused 'no material in use matches the light "sun"' --light sun=1,1,1 room.obj
refused '--scale: expected a number above 0' --scale 0 room.obj
refused 'nan' --scale nan room.obj
refused 'x' --up x room.obj

strad-import --light 'l*=4,5,6' --scale 2 --up z -o lit.strad room.obj
! cmp -s lit.strad file.strad
