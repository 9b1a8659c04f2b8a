# The baked meshes can be included by name: one body, with its pose, beside an object of the user's own.
room=$STRAD_SOURCE_DIR/tests/pipelines/pov_room
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

strad-import "$room/room.obj" | strad-motion "$room/room.motion" | strad-solve -e 0.5 >room.strad
strad-frame -f 6 --direct mesh --pov -o 'room.%d.inc' room.strad
cat >own.pov <<'END'
#version 3.7;
global_settings { assumed_gamma 1 adc_bailout 1e-5 }
#declare strad_exposure = 2;
#include "room.6.inc"
#include strad_geometry
camera { strad_camera }
#ifdef (CART) object { strad_body_mover transform { strad_pose_mover } } #end
#ifdef (WALLS) object { strad_body_world } #end
#ifdef (BALL) sphere { <1, 1.5, 0.5>, 0.3 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.5 } } #end
END
render() { povray own.pov -D -A +W64 +H48 +FE +O"$1.exr" "${@:2}" >log 2>&1 || { cat log; exit 1; }; }
render cart Declare=CART=1
render walls Declare=WALLS=1
render all Declare=CART=1 Declare=WALLS=1
render ball Declare=CART=1 Declare=WALLS=1 Declare=BALL=1
for part in cart walls ball; do
  if strad-diff --rel-rmse 0.01 $part.exr all.exr; then exit 1; fi
done
# Twice the light is one stop more.
strad-frame -f 6 -s 64x48 --samples 1 --direct mesh --exposure 1 -o frame.exr room.strad
strad-diff --rel-rmse 0.01 all.exr frame.exr
