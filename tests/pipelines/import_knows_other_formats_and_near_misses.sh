# A file of another format is told by its first bytes, and a mistyped option or name by what it is like.
scenes=$STRAD_SOURCE_DIR/scenes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

refused() {  # refused EXPECTED COMMAND...
  local expected=$1 status=0
  shift
  "$@" >out 2>err </dev/null || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF -e "$expected" err || [ -s out ]; then
    echo "$*: status $status, said:"
    cat err
    exit 1
  fi
}
printf 'glTF\2\0\0\0' >a.obj
refused 'a.obj: is a glTF 2.0 file: use --from gltf' strad-import a.obj
printf '  {\n "asset": { "version": "2.0" } }' >b.obj
refused 'b.obj: is a glTF 2.0 file: use --from gltf' strad-import b.obj
printf 'Kaydara FBX Binary  \0' >c.pov
refused 'c.pov: is an FBX file: convert it to glTF 2.0' strad-import c.pov
strad-import -q "$scenes/cornell/cornell.obj" >d.obj
refused 'd.obj: is a strad stream: it is imported already' strad-import d.obj

refused 'did you mean --skip-unknown?' strad-import --skip-unknwon "$scenes/cornell/cornell.obj"
refused 'did you mean --frames?' strad-frame --farmes=1 d.obj
printf 'body a\n  parts box11\n  key 0 move 0 0 0\n' >near.motion
strad-import -q "$scenes/room4/room4.obj" >room.strad
refused 'did you mean box1?' strad-motion near.motion room.strad
