# POV-Ray renders both exports as strad-frame renders the solution: within 1 % where all light is baked, within 2 % with its own
# lights. The room has all that is special: a panel lit on both sides, a texture, a body that moves, a spot wider than a half-space
# (cut from three of POV-Ray's), a lamp that is a triangle, black paint that emits, a glow.
room=$STRAD_SOURCE_DIR/tests/pipelines/pov_room
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

strad-import "$room/room.obj" | strad-motion "$room/room.motion" | strad-solve -e 0.05 >room.strad
for camera in front back; do
  for direct in mesh:0.01 pixel:0.02; do
    name=$camera-${direct%:*}
    mkdir "$name"
    common=(-f 3:8:5 -s 120x90 -c $camera --direct "${direct%:*}")
    strad-frame "${common[@]}" --samples 1 -o "$name.%d.exr" room.strad
    strad-frame "${common[@]}" --pov -o "$name/pov.%d.inc" room.strad
    povray "$name/pov.ini" -A +FE +O"$name.pov" >povray.log 2>&1 || { cat povray.log; exit 1; }
    for frame in 3 8; do
      echo "$name frame $frame"
      strad-diff --rel-rmse "${direct#*:}" "$name.pov$frame.exr" "$name.$frame.exr"
    done
  done
done
# What was compared moves and is lit.
if strad-diff --rel-rmse 0.1 front-pixel.3.exr front-pixel.8.exr; then exit 1; fi
if strad-diff --rel-rmse 0.1 front-pixel.3.exr back-pixel.3.exr; then exit 1; fi
