# PLY frames: sizes follow from the header; all frames have one topology; what does not move stays where it is.
room=$STRAD_SOURCE_DIR/tests/pipelines/pov_room
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

strad-import "$room/room.obj" | strad-motion "$room/room.motion" | strad-solve -e 0.5 >room.strad
strad-frame -f 1:9:4 --ply -o 'room.%d.ply' room.strad
for k in 1 5 9; do
  header=$(sed '/^end_header$/q' room.$k.ply | tr -d '\0')
  vertices=$(sed -n 's/^element vertex //p' <<<"$header")
  faces=$(sed -n 's/^element face //p' <<<"$header")
  [ "$vertices" -gt 40 ] && [ "$faces" -gt 20 ]
  [ "$(stat -c %s room.$k.ply)" = $((${#header} + 1 + 27 * vertices + 13 * faces)) ]
  tail -c $((13 * faces)) room.$k.ply >faces.$k
  body=$((${#header} + 1))
  dd if=room.$k.ply of=first.$k bs=1 count=12 skip=$body status=none
  dd if=room.$k.ply of=last.$k bs=1 count=12 skip=$((body + 27 * (vertices - 1))) status=none
done
cmp faces.1 faces.5
cmp faces.1 faces.9
cmp first.1 first.9  # of the world
if cmp -s last.1 last.9; then exit 1; fi  # of the body that moves
strad-frame -f 5 --ply room.strad | cmp - room.5.ply
