# strad-frame renders the frames and times asked for, under the names asked for, or refuses in one line and writes nothing.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

strad-import $scene.obj | strad-motion $scene.motion | strad-solve -e 0.3 --time 2:2.4 >solved.strad
frame() { strad-frame -s 8x8 --samples 1 "$@" solved.strad; }

mkdir out
frame -o 'out/a.%03d.ppm'  # all that are solved: 2 s is frame 51 of 25 a second, 2.4 s frame 61
[ "$(ls out | head -1) $(ls out | tail -1) $(ls out | wc -l)" = "a.051.ppm a.061.ppm 11" ]
rm out/*
frame -f 52:60:4 -o 'out/%d%%.pfm'
[ "$(ls out | tr '\n' ' ')" = "52%.pfm 56%.pfm 60%.pfm " ]
rm out/*
frame -f 60,51:55:2 -o 'out/%d.pfm'
[ "$(ls out | tr '\n' ' ')" = "51.pfm 53.pfm 55.pfm 60.pfm " ]
rm out/*
frame -t 2.3,2.04 -o 'out/t%2d.pfm'  # times are numbered in the order given
[ "$(ls out | tr '\n' ';')" = "t 1.pfm;t 2.pfm;" ]
frame -f 52 -o out/frame52.pfm
cmp 'out/t 2.pfm' out/frame52.pfm  # frame 52 is at 2.04 s
rm out/*

# PPM by default, three bytes per pixel after the header.
[ "$(frame -f 51:53 | wc -c)" = $((3 * (8 * 8 * 3 + $(printf 'P6\n8 8\n255\n' | wc -c)))) ]
[ "$(frame -f 51 --pfm | head -c 2)" = PF ]

refused() { # expected text, arguments
  local status=0 text=$1
  shift
  frame "$@" >stdout 2>stderr || status=$?
  if [ $status != 2 ] || [ "$(wc -l <stderr)" != 1 ] || ! grep -q "$text" stderr || [ -s stdout ] || [ -n "$(ls out)" ]; then
    echo "$*: exit status $status"
    cat stderr
    ls out
    exit 1
  fi
}
refused '^strad-frame: --frames: frame 62 is at 2.44 s, but the solution holds 2 to 2.4 s' -f 60:62 -o 'out/%d.ppm'
refused 'expected A, A:B or A:B:S with frames 1 to 250' -f 3:1 -o 'out/%d.ppm'
refused '^strad-frame: --time: found 7 s' -t 7 -o out/x.ppm
refused 'found both' -f 51 -t 2 -o out/x.ppm
refused 'for 2 frames, expected a number in it' -f 51:52 -o out/x.ppm
refused 'expected a number written %d' -f 51:52 -o 'out/%s.ppm'
refused "found 'side', expected one of main" -f 51 -c side -o out/x.ppm
refused 'expected WxH' -s 0x8 -f 51 -o out/x.ppm
refused 'xyz' -f 51 -o out/x.xyz
refused 'fraction of a frame' -f 51 --shutter 1.5 -o out/x.ppm
refused '1 to 65536' -f 51 --samples 0 -o out/x.ppm
refused 'standard output' -f 51 --pfm -o out/x.pfm
refused 'pixel' -f 51 --direct points -o out/x.pfm
refused 'one of them' -f 51 --pov --ply -o out/x.inc

# A stream without a solution, and one without a camera.
strad-import $scene.obj | { ! strad-frame 2>stderr | grep -q .; }
grep -q '^strad-frame: .*no solution' stderr
printf 'time 0 1\nrate 25\n' | strad-motion - <(strad-import $scene.obj) | strad-solve -e 0.5 >bare.strad
if strad-frame -f 1 bare.strad >stdout 2>stderr; then exit 1; fi
grep -q 'no camera' stderr
