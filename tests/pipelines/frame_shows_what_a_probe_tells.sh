# A pixel that shows one small piece of a surface has the radiance that a probe finds there, for every kind of direct light.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

# A camera that looks at 1 cm of the floor.
{
  cat $scene.motion
  echo 'camera close'
  echo '  key 0 from 4.3 1 1 to 4.5 0.8 0 up 0 0 1 fov 0.5'
} >close.motion
strad-import $scene.obj | strad-motion close.motion | strad-solve -e 0.2 --time 2:2.4 >solved.strad

check() { # arguments of both
  strad-frame -c close -s 1x1 --samples 64 -f 55 --pfm "$@" solved.strad | tail -c 12 | od -An -tf4 >frame
  strad-probe --at 4.5,0.8,0,0,0,1 --frames "$@" solved.strad | awk '$1 == 2.16 { print $4, $5, $6 }' >probe
  paste frame probe | awk '{ for (c = 1; c <= 3; ++c) { d = $c / $(c + 3) - 1; if (!(d * d < 1e-4)) { print; exit 1 } } }'
}
check --direct pixel
check --direct mesh
check --direct mesh --flat
