# Files named in a scene may have names that no file can have, be devices without an end, or pipes that nobody
# writes: each is refused in one line, or left out when that is asked for.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

# refused PATTERN ARGUMENT...: exit status 2 and one line that matches.
refused() {
  local status=0
  timeout 60 strad-import "${@:2}" >out 2>err || status=$?
  test $status = 2 || { echo "strad-import ${*:2}: exit status $status"; cat err; exit 1; }
  test "$(wc -l <err)" = 1 && grep -q "^strad-import: .*$1" err || { cat err; exit 1; }
  test ! -s out
}

long=$(printf 'x%.0s' {1..300})
square='v 0 0 0\nv 1 0 0\nv 0 1 0\n'
printf "mtllib $long\n${square}f 1 2 3\n" >a.obj
refused 'material file ".*" is missing' a.obj
strad-import --skip-missing a.obj 2>/dev/null >a.strad

printf "newmtl m\nmap_Kd $long.png\n" >m.mtl
printf "mtllib m.mtl\nusemtl m\n${square}f 1 2 3\n" >b.obj
refused 'texture ".*" is missing' b.obj
strad-import --skip-missing b.obj 2>/dev/null >b.strad

echo "#include \"$long\" sphere { 0, 1 }" >c.pov
refused 'included file ".*" is missing' c.pov
strad-import --skip-missing c.pov 2>/dev/null >c.strad

echo "sphere { 0, 1 pigment { image_map { png \"$long\" } } }" >d.pov
refused 'image ".*" is missing' d.pov
strad-import --skip-missing d.pov 2>/dev/null >d.strad

echo "Input_File_Name=$long" >e.ini
refused 'cannot be opened: File name too long' e.ini

# Without an end.
echo 'triangle { 0, x, y pigment { image_map { png "/dev/zero" } } }' >f.pov
refused 'f.pov:1: /dev/zero: is no plain file' f.pov
printf "mtllib /dev/zero\n${square}f 1 2 3\n" >g.obj
refused 'g.obj:1: material file "/dev/zero" is no plain file' g.obj
mkfifo m.fifo
printf "mtllib m.fifo\n${square}f 1 2 3\n" >i.obj
refused 'i.obj:1: material file "m.fifo" is no plain file' i.obj
refused '/dev/zero: is not a text file' /dev/zero
refused '/dev/zero: is not a glTF file' --from gltf /dev/zero

# A picture with a number that is not finite, as PFM and as EXR would hold it.
printf 'PF\n1 1\n-1.0\n\0\0\0\0\0\0\300\177\0\0\0\0' >nan.pfm
printf 'newmtl m\nmap_Kd nan.pfm\n' >m.mtl
refused 'nan.pfm: pixel 0,0 is not finite' b.obj

# Pipes: one that nobody writes, and one whose writer computes for longer than is waited for a writer.
mkfifo silent slow
refused 'silent: is a pipe that no program writes, expected a text file' silent &
{ exec 3>slow; sleep 11; printf "${square}f 1 2 3\n" >&3; } &
strad-import slow 2>/dev/null >h.strad
test -s h.strad
wait %1
