# --preview and --plan show a scene that was never solved, for every frame; strad-motion warns of what is probably wrong.
scenes=$STRAD_SOURCE_DIR/scenes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

strad-import -q "$scenes/room4/room4.obj" | strad-motion "$scenes/room4/room4.motion" >room.strad 2>err
[ ! -s err ] || { echo "a sound scene is warned of:"; cat err; exit 1; }
strad-frame --preview -s 32x24 -f 1:50:10 room.strad >preview.ppm
[ "$(wc -c <preview.ppm)" = $((5 * (13 + 32 * 24 * 3))) ]  # "P6\n32 24\n255\n" is 13 bytes
strad-frame --preview -s 32x24 -t 0,8 -o 'p.%d.pfm' room.strad
! cmp -s p.1.pfm p.2.pfm || { echo "nothing moves"; exit 1; }
strad-frame --plan -s 64x64 -t 3 -o plan.png room.strad
# Without a camera there is a plan, but no preview.
strad-import -q "$scenes/room4/room4.obj" | strad-frame --plan -s 64x64 -t 0 -o none.png
strad-import -q "$scenes/room4/room4.obj" | strad-frame --preview -t 0 >out 2>err && exit 1
grep -q 'the stream has no camera' err

for others in '--preview --plan' '--preview --flat' '--plan --pov -o a.%d.inc' '--preview --show elements'; do
  status=0
  strad-frame $others room.strad >out 2>err || status=$?
  [ $status = 2 ] && [ "$(wc -l <err)" = 1 ] && [ ! -s out ] || { echo "$others: status $status"; cat err; exit 1; }
done

# Warnings are notes: the stream is the same with and without them.
cat >late.motion <<'END'
time 0 1
body box
  parts box1
  key 0 move 0 0 0
  key 2 move 1 0 0
END
strad-import -q "$scenes/room4/room4.obj" >plain.strad
strad-motion late.motion plain.strad >a 2>err
grep -q '^strad-motion: warning: body box has 1 key after the end, 1 s: the last is at 2 s$' err
grep -q '^strad-motion: warning: the scene has no light' err
strad-motion -q late.motion plain.strad >b 2>err
[ ! -s err ]
cmp a b
