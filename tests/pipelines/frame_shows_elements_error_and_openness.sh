# strad-frame --show: the same bytes for any number of threads and any subset of frames; what makes no sense is refused.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

strad-import $scene.obj | strad-motion $scene.motion >scene.strad
strad-solve -e 0.3 --time 2.2:2.6 scene.strad >solved.strad
show() { strad-frame -s 40x40 --samples 4 "$@" solved.strad; }
for what in elements error openness; do
  show -j 1 --show $what -f 60:61 -o "$what.one.%d.pfm"
  show -j 3 --show $what -f 60:61 -o "$what.three.%d.pfm"
  show --show $what -f 61 --pfm | cmp - $what.one.61.pfm
  cmp $what.one.60.pfm $what.three.60.pfm
  cmp $what.one.61.pfm $what.three.61.pfm
  if cmp -s $what.one.60.pfm $what.one.61.pfm; then exit 1; fi  # the boxes have moved between the two
  strad-frame -s 40x40 --samples 4 --show $what -f 61 --pfm <solved.strad | cmp - $what.one.61.pfm
done
# The three differ. Openness needs no solution, the others do.
if cmp -s elements.one.60.pfm error.one.60.pfm || cmp -s error.one.60.pfm openness.one.60.pfm; then exit 1; fi
strad-frame -s 40x40 --samples 4 --show openness -f 60 --pfm scene.strad | cmp - openness.one.60.pfm

# The room is 0.6 m wide and open in front: farther on, less is open; one stop doubles what is shown.
sum() { tail -c $((40 * 40 * 12)) | od -An -v -w12 -tf4 | awk '{ s += $1 } END { print s }'; }
near=$(show --show openness --within 0.02 -f 60 --pfm | sum)
far=$(show --show openness --within 5 -f 60 --pfm | sum)
brighter=$(show --show openness --within 5 --exposure 1 -f 60 --pfm | sum)
awk -v n="$near" -v f="$far" -v b="$brighter" 'BEGIN { exit !(f > 0 && n > 1.5 * f && b > 1.999 * f && b < 2.001 * f) }'

refused() { # expected text, arguments
  local status=0 text=$1
  shift
  strad-frame -s 8x8 "$@" >stdout 2>stderr || status=$?
  if [ $status != 2 ] || [ "$(wc -l <stderr)" != 1 ] || ! grep -q -e "$text" stderr || [ -s stdout ]; then
    echo "$*: exit status $status"
    cat stderr
    exit 1
  fi
}
refused "^strad-frame: --show: found 'links', expected elements|error|openness" --show links -f 60 solved.strad
refused '^strad-frame: --show: for pictures' --show error --flat -f 60 solved.strad
refused '^strad-frame: --show: for pictures' --show error --ply -f 60 solved.strad
refused '^strad-frame: --within: for --show openness only' --show error --within 1 -f 60 solved.strad
refused '^strad-frame: --within: expected a length above 0 m' --show openness --within -1 -f 60 solved.strad
refused 'no solution' --show elements -f 60 scene.strad
