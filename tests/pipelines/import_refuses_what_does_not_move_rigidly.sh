# An object that deforms, appears, vanishes or changes its colour is named with its line and the frame; with --skip-unknown
# it is left out or stays as it is in the first frame, which is said.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

cat >head.inc <<'END'
#default { pigment { rgb 0.5 } finish { diffuse 1 } }
box { <0, 0, 0>, <4, 4, 4> }
END
try() {  # try POV-TEXT EXPECTED-REFUSAL EXPECTED-NOTE: line 2 of s.pov is the text
  printf '#include "head.inc"\n%s\n' "$1" >s.pov
  status=0
  strad-import --frames 11 --clock 0:1 s.pov >out 2>err || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF "strad-import: s.pov:2: $2" err || [ -s out ]; then
    echo "exit status $status, expected: $2"
    cat err
    exit 1
  fi
  strad-import --skip-unknown --frames 11 --clock 0:1 s.pov >out 2>err || { cat err; exit 1; }
  grep -qF "$3" err || { echo "expected: $3"; cat err; exit 1; }
}
try 'sphere { 0, 1 scale 1 + clock }' 'the object sphere changes its shape in frame 2 (clock 0.1)' \
  'the object sphere changes its shape in frame 2 (clock 0.1): kept as it is in the first frame'
try 'box { 0, 1 scale <1, 1 + (clock > 0.45), 1> translate x * clock }' 'the object box changes its shape in frame 6' 'kept as it is in the first frame'
try '#if (clock > 0.75) #declare Late = box { 0, 1 } object { Late } #end' 'the object Late appears in frame 9' 'the object Late appears in frame 9 (clock 0.8): left out'
try '#if (clock < 0.75) cylinder { 0, y, 1 } #end' 'the object cylinder vanishes in frame 9' 'kept as it is in the first frame'
try 'box { 0, 1 pigment { rgb clock } }' 'the object box changes its colour in frame 2' 'its colour is that of the first frame'
try 'light_source { y, 1 spotlight point_at 0 falloff 20 + clock }' 'the object light_source changes the cone of its light in frame 2' \
  'its light is that of the first frame'
# What was left out does not move: no body, but for the box that moves besides.
printf '#include "head.inc"\nsphere { 0, 1 scale 1 + clock } box { 4, 5 translate x * clock }\n' >s.pov
strad-import -q --skip-unknown --frames 11 --clock 0:1 s.pov | strad-motion --print >motion
[ "$(grep -c '^body' motion)" = 1 ]
grep -A3 '^body' motion | grep -qx '  key 0.4  move 1 0 0'

# Errors of a later frame say which.
printf '#include "head.inc"\n#if (clock > 0.5) #error "too late" #end\n' >s.pov
if strad-import --frames 11 --clock 0:1 s.pov >out 2>err; then exit 1; fi
grep -qx 'strad-import: s.pov:2: #error "too late", in frame 7 (clock 0.6)' err || { cat err; exit 1; }

refused() {  # refused EXPECTED-TEXT ARGUMENTS...
  local status=0 expected=$1
  shift
  strad-import "$@" >out 2>err || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF -e "$expected" err || [ -s out ]; then
    echo "strad-import $*: exit status $status, expected 2 and: $expected"
    cat err
    exit 1
  fi
}
refused '--frames' --frames 1 s.pov
refused '--frames' --frames 5:2 s.pov
refused '--clock' --clock 0:1 s.pov
refused '--clock' --frames 5 --clock 0 s.pov
refused '--rate' --frames 5 --rate 0 s.pov
printf 'Input_File_Name=s.pov\nFinal_Frame=ten\n' >bad.ini
refused 'bad.ini:2: Final_Frame is "ten", expected a whole number' bad.ini
printf 'Input_File_Name=s.pov\nWitdh=10\n' >bad.ini
refused 'bad.ini:2: found setting "Witdh"' bad.ini
printf '[low]\nWidth=10\n' >bad.ini
refused 'found no Input_File_Name' bad.ini
printf 'Input_File_Name=s.pov\nFinal_Frame=10\nSubset_Start_Frame=12\n' >bad.ini
refused 'the subset has frame 12, expected 1 to 10' bad.ini
printf 'Input_File_Name=absent.pov\n' >bad.ini
refused 'absent.pov' bad.ini
