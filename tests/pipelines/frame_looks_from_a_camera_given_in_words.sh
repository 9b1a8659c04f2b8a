# --camera-at is a camera of a motion file in one option: the same bytes, with no motion file and no new solve.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell
look='from 0.3 0.3 0.6 to 0.27 0.2 -0.2 up 0 1 0.1 fov 50'

strad-import -q $scene.obj | strad-motion $scene.motion | strad-solve -q -e 0.5 --at 2 >solved.strad
printf 'camera look\n  key 0 %s\n' "$look" | strad-motion - solved.strad >look.strad 2>note
[ ! -s note ]
strad-frame -t 2 -s 24x24 --samples 1 -c look look.strad >a.ppm
strad-frame -t 2 -s 24x24 --samples 1 --camera-at "$look" solved.strad >b.ppm
cmp a.ppm b.ppm
strad-frame -t 2 -s 24x24 --samples 1 solved.strad | if cmp -s - a.ppm; then echo 'the camera changed nothing'; exit 1; fi

refused() {  # refused EXPECTED-TEXT ARGUMENTS...
  local status=0 expected=$1
  shift
  strad-frame -t 2 "$@" solved.strad >out 2>err || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF -e "$expected" err || [ -s out ]; then
    echo "strad-frame $*: exit status $status, expected 2 and: $expected"
    cat err
    exit 1
  fi
}
refused '--camera-at: found a first key without to, expected' --camera-at 'from 0 1 2'
refused '--camera-at: found "fob", expected from, to, up and fov' --camera-at 'from 0 1 2 to 0 0 0 fob 3'
refused '--camera-at: found several lines' --camera-at $'from 0 1 2 to 0 0 0\nfov 3'
refused '--camera and --camera-at: found both' --camera-at "$look" -c main
