# Every scene of scenes/ goes through import and motion, and has a camera `main`.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

"$STRAD_SOURCE_DIR/scenes/halls/halls.sh" 2000 halls
cp -r "$STRAD_SOURCE_DIR"/scenes/*/ .
count=0
for obj in */*.obj; do
  scene=${obj%.obj}
  strad-import "$obj" | strad-motion "$scene.motion" >scene.strad
  strad-info scene.strad | sed -n '/cameras:/,$p' | grep 'name main' >/dev/null || { echo "$scene: no camera main"; exit 1; }
  count=$((count + 1))
done
[ $count -ge 10 ] || { echo "only $count scenes"; exit 1; }
