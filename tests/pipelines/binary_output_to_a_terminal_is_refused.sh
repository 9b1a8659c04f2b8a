# Tools that write streams or pictures refuse a terminal, in one line and with status 2; text goes there.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/shutter/shutter

strad-import $scene.obj >scene.strad
strad-motion $scene.motion scene.strad >moving.strad
strad-solve -e 0.3 moving.strad >solved.strad

on_terminal() { script -qec "$1" /dev/null </dev/null | tr -d '\r'; }  # its status is the command's

refused() {
  local status=0
  on_terminal "$1" >out || status=$?
  if [ $status != 2 ] || [ "$(wc -l <out)" != 1 ] || ! grep -q "^${1%% *}: .*terminal" out; then
    echo "$1: exit status $status"
    cat -v out | head -5
    exit 1
  fi
}
refused "strad-import $scene.obj"
refused "strad-motion $scene.motion scene.strad"
refused "strad-solve -e 0.3 moving.strad"
refused "strad-frame -f 1 -s 8x8 solved.strad"
refused "strad-join solved.strad"

on_terminal "strad-info solved.strad" >out
test -s out
on_terminal "strad-probe --at 0,0,0 -n 2 solved.strad" | grep time >/dev/null
on_terminal "strad-solve -e 0.3 -o file.strad moving.strad" >/dev/null
test -s file.strad
