# A reader that closes the pipe ends each tool without a message.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/shutter/shutter

strad-import $scene.obj >scene.strad
strad-motion $scene.motion scene.strad >moving.strad
strad-solve -e 0.3 moving.strad >solved.strad

quiet() {  # quiet COMMAND...: into a pipe that nobody reads
  "$@" 2>err | true
  if [ -s err ]; then
    echo "$*:"
    cat err
    exit 1
  fi
}
set +o pipefail
quiet strad-import $scene.obj
quiet strad-motion $scene.motion scene.strad
quiet strad-solve -e 0.3 moving.strad
quiet strad-frame -f 1:20 -s 40x40 --direct mesh solved.strad
quiet strad-probe --at 0,0,0 -n 100000 solved.strad
quiet strad-info solved.strad
quiet strad-join solved.strad
quiet strad-diff solved.strad solved.strad
