# What cannot be exported is refused before anything is written.
room=$STRAD_SOURCE_DIR/tests/pipelines/pov_room
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

strad-import "$room/room.obj" | strad-motion "$room/room.motion" | strad-solve -e 0.5 --at 0.5 >room.strad
refused() {
  local status=0
  strad-frame "$@" room.strad 2>errors || status=$?
  [ $status = 2 ] || { echo "$*: status $status, expected 2"; exit 1; }
  [ "$(wc -l <errors)" = 1 ] || { echo "$*:"; cat errors; exit 1; }
  [ "$(ls)" = "$(printf 'errors\nroom.strad')" ] || { echo "$*:"; ls; exit 1; }
}
refused -t 0.5 --pov
refused -t 0.5 --pov -o still.pov
refused -t 0.5 --pov -o 'a"b.inc'
refused -t 0.5 --pov -o 'a.%s.inc'
refused -t 0.5 --pov --ply -o a.inc
