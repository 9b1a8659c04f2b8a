# A frame missing on either side is trouble; what flickers is measured over three consecutive frames.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

picture() { printf "PF\n1 1\n-1\n$1$1$1"; }
one='\0\0\200\077' two='\0\0\0\100'
for k in 1 2 3; do
  picture $one >a.000$k.pfm
  picture $one >b.000$k.pfm
done
strad-diff a.%04d.pfm b.%04d.pfm | grep -x 'frames 3'

# Luminance 1 2 1: the second difference is -2 and the mean of the middle frame 2, so 1; 0 for the steady reference.
picture $two >b.0002.pfm
if strad-diff a.%04d.pfm b.%04d.pfm >out; then exit 1; fi
grep -x 'max_file b.0002.pfm' out
grep -x 'flicker_a 0' out
grep -x 'flicker_b 1' out
strad-diff a.%04d.pfm b.%04d.pfm --flicker 1.001 >/dev/null
if strad-diff a.%04d.pfm b.%04d.pfm --flicker 0.999 >/dev/null; then exit 1; fi
strad-diff a.%04d.pfm b.%04d.pfm -f 1,3 >/dev/null

trouble() {  # trouble TEXT ARGUMENTS...
  local text=$1 status=0
  shift
  strad-diff "$@" 2>err || status=$?
  test $status = 2
  grep -qF "$text" err
}
picture $one >b.0004.pfm
trouble 'a.0004.pfm: no such file' a.%04d.pfm b.%04d.pfm
trouble 'a.0004.pfm: no such file' a.%04d.pfm b.%04d.pfm -f 1:5
rm b.0004.pfm b.0003.pfm
trouble 'b.0003.pfm: no such file' a.%04d.pfm b.%04d.pfm
trouble 'c.%04d.pfm' c.%04d.pfm a.%04d.pfm
trouble 'one file' a.0001.pfm b.%04d.pfm
trouble 'a pattern' a.%04d.pfm b.%04d.pfm --twin a.0001.pfm
