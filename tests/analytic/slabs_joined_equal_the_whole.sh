# Two halves of the animation solved apart and joined cover all of it, and have the light of the whole solved at once,
# within the error asked for; what they hold is not changed by joining.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/lamp/lamp
error=0.2

strad-import $scene.obj | strad-motion $scene.motion >scene.strad
strad-solve -e $error --time 2:6 scene.strad >whole.strad
strad-solve -e $error --time 2:3.5 scene.strad >first.strad
strad-solve -e $error --time 3.5:6 scene.strad >second.strad
strad-join second.strad first.strad >joined.strad

strad-diff whole.strad joined.strad --rel-rmse $error || { echo "joined differs from the whole"; exit 1; }

points='--at 2.5,2,0 --at 1,3.9,3 --at 0,1,1.5 --at 4.2,2.6,0.6 --at 2.6,2,1.5'
strad-probe -n 9 --direct mesh $points whole.strad >whole
strad-probe -n 9 --direct mesh $points joined.strad >joined   # 2, 2.5 .. 6 s
paste whole joined | awk -v error=$error '
  NR > 1 { if ($1 != $10) exit 1; d = $4 - $13; squares += d * d; sum += $4; n++ }
  END {
    difference = sqrt(squares / n) / (sum / n)
    printf "rms difference %.3g of the mean radiance\n", difference
    exit !(n == 45 && difference < error)
  }'
strad-probe -n 4 --direct mesh $points first.strad >first   # 2, 2.5, 3 s; at 3.5 s the joined has the second
awk 'NR > 1 && $1 < 3.25' first >a
awk 'NR > 1 && $1 < 3.25' joined >b
cmp a b
