# Two motion files in a row are as good as one that holds both texts, and the same one twice as once.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
room=$STRAD_SOURCE_DIR/scenes/room4/room4

cat >vary.motion <<'END'
rate 10
spot cart
  cone 5 10
  key 0 at 1 1 1 aim 2 2 0 intensity 1 2 3
body roller
  on cart
  parts box4
END
cat $room.motion vary.motion >both.motion
content() { strad-info "$1" | sed -n '/^scene:/,/^bytes:/p'; }

strad-import $room.obj >rest.strad
strad-motion $room.motion rest.strad >once.strad
strad-motion $room.motion once.strad >again.strad
strad-motion vary.motion once.strad >varied.strad
strad-motion - rest.strad <both.motion >joined.strad

content once.strad | cmp - <(content again.strad)
content varied.strad | cmp - <(content joined.strad)
if content once.strad | cmp -s - <(content varied.strad); then
  echo "the second motion changed nothing"
  exit 1
fi
content varied.strad | grep 'roller, on cart, objects 1' >/dev/null
