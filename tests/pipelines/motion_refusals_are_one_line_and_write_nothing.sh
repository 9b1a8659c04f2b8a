# What is wrong with a motion file or its stream: one line on standard error, status 2, no output.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell
strad-import $scene.obj >scene.strad

refused() {  # refused EXPECTED-TEXT ARGUMENTS...
  local status=0 expected=$1
  shift
  strad-motion "$@" -o out.strad 2>err </dev/null || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF "$expected" err || [ -e out.strad ]; then
    echo "strad-motion $*: exit status $status, expected 2 and: $expected"
    cat err
    exit 1
  fi
}

printf 'time 0 10\nbody tall\n  parts tower*\n' >bad.motion
refused 'strad-motion: bad.motion:3: found no object named "tower*", expected' bad.motion scene.strad
refused 'absent.motion' absent.motion scene.strad
refused 'absent.strad' $scene.motion absent.strad
refused 'scene.strad' scene.strad scene.strad
refused "$scene.motion" $scene.motion $scene.motion
refused 'standard input' - -
refused 'standard input' -
head -c 100 scene.strad >cut.strad
refused 'cut.strad' $scene.motion cut.strad
