# Solved alone, an instant has the light that the space-time solution has at that time: within the error that each was
# asked for, over points on all surfaces of a room with a moving area lamp, a turning fin and a panel that is
# switched on.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/lamp/lamp
error=0.1

awk 'BEGIN {  # 12 points on each side of the room
  for (i = 0; i < 4; i++) for (j = 0; j < 3; j++) {
    u = (i + 0.37) / 4; v = (j + 0.41) / 3
    print 5 * u, 4 * v, 0; print 5 * u, 4 * v, 3
    print 5 * u, 0, 3 * v; print 5 * u, 4, 3 * v
    print 0, 4 * u, 3 * v; print 5, 4 * u, 3 * v
  }
}' >points
strad-import $scene.obj | strad-motion $scene.motion >scene.strad
strad-solve -e $error --time 5:7 scene.strad >whole.strad
strad-probe -n 5 --direct mesh --points points whole.strad >table  # at 5, 5.5, 6, 6.5, 7 s; the switch is at 6 s
for time in 5.5 6.5; do
  strad-solve -e $error --at $time scene.strad >instant.strad
  strad-probe --direct mesh --points points instant.strad >instant
  awk -v time=$time '$1 == time' table | paste - <(tail -n +2 instant) | awk -v time=$time -v error=$error '
    { for (c = 4; c <= 6; c++) { d = $c - $(c + 9); squares += d * d; sum += $c; n++ } }
    END {
      difference = sqrt(squares / n) / (sum / n)
      printf "at %g s: rms difference %.3g of the mean radiance\n", time, difference
      exit !(n == 216 && difference < error && difference > 0)
    }'
done
