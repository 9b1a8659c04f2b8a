# strad-info tells of clusters, links and rays of every slab, as --stats does; what was solved before is not told once
# the motion has changed.
scene=$STRAD_SOURCE_DIR/scenes/lamp/lamp
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

# work FILE NAME: the values of that name in the part `work`.
work() { strad-info "$1" >info; sed -n '/^work:/,/^bytes:/p' info | tr ',' '\n' | sed -n "s/^[- ]*$2 \([0-9]*\)$/\1/p" | paste -sd' '; }

strad-import -q $scene.obj | strad-motion -q $scene.motion >scene
strad-solve -q -e 0.5 --time 0:5 --stats stats scene >a
strad-solve -q -e 0.5 --time 5:10 scene >b
strad-join a b >both
[ "$(work a clusters)" -gt 0 ]
[ "$(work a clusters)" = "$(tr -d ' ,' <stats | sed -n 's/^"clusters"://p')" ]
[ "$(work both clusters)" = "$(work a clusters) $(work b clusters)" ]
[ "$(work both rays)" = "$(work a rays) $(work b rays)" ]

strad-solve -q -e 0.5 --no-clusters both >flat
[ "$(work flat clusters)" = 0 ]
[ "$(work flat links)" -gt 0 ]

strad-motion -q <(echo 'time 0 9') both >moved
[ -z "$(work moved clusters)" ]
