# Reference frames need no solution, have the same bytes for any number of threads and any subset of frames, and agree
# with closed forms: a closed box of Le = 1, rho = 0.5 shows L = Le / (1 - rho) = 2; under a lamp of 1 x 1 m and
# radiance 10 at height 1 m, a floor of rho = 0.5 has E = 4 * 10 / 2 * 2 g(0.5, 0.5), L = E / (2 pi)
# (scenes/rising_lamp).
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scenes=$STRAD_SOURCE_DIR/scenes

# The mean of all values of a picture is WANT within 4 standard errors (a chance of 6e-5 that noise alone fails).
# Rows of pixels are independent, so the deviation over pixels tells the error.
agrees() { # agrees WANT PIXELS FILE
  tail -c $(($2 * 12)) "$3" | od -An -v -w12 -tf4 | awk -v want="$1" -v name="$3" '
    { sum += $2; squares += $2 * $2 }
    END {
      mean = sum / NR
      error = sqrt((squares / NR - mean * mean) / NR) + 1e-5 * want
      print name ": " mean " +- " error ", expected " want
      exit !(mean > want - 4 * error && mean < want + 4 * error && error < 0.02 * want)
    }'
}

strad-import $scenes/furnace/furnace.obj | strad-motion $scenes/furnace/furnace.motion >furnace.strad
strad-frame --reference 32 -s 24x24 -f 1 --pfm furnace.strad >furnace.pfm
agrees 2 576 furnace.pfm

{
  cat $scenes/rising_lamp/rising_lamp.motion
  echo 'camera close'
  echo '  key 0 from 1.5 0 0.3 to 0 0 0 up 0 0 1 fov 0.2'
} >close.motion
strad-import $scenes/rising_lamp/rising_lamp.obj | strad-motion close.motion >lamp.strad
strad-frame --reference 64 -s 16x16 -c close -t 2 --pfm lamp.strad >lamp.pfm
want=$(awk 'BEGIN { r = sqrt(1.25); print 4 * 5 * 2 * 0.5 / r * atan2(0.5, r) / 6.283185307 }')
agrees "$want" 256 lamp.pfm

scene=$scenes/cornell/cornell
strad-import $scene.obj | strad-motion $scene.motion >scene.strad
for jobs in 1 2; do
  strad-frame -j $jobs --reference 4 --shutter 0.5 -s 20x20 -f 60:61 -o "$jobs.%d.pfm" scene.strad
done
strad-frame --reference 4 --shutter 0.5 -s 20x20 -f 61 -o alone.pfm scene.strad
cmp 1.60.pfm 2.60.pfm
cmp 1.61.pfm 2.61.pfm
cmp 1.61.pfm alone.pfm
strad-frame --reference 4 --shutter 0.5 -s 20x20 -f 61 --seed 1 -o other.pfm scene.strad
if cmp -s alone.pfm other.pfm; then exit 1; fi
