# The bytes of a solution do not depend on -j.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

strad-import $scene.obj | strad-motion $scene.motion >scene.strad
for jobs in 1 2 5; do
  strad-solve -j $jobs -e 0.3 --time 2:3 scene.strad >$jobs.strad
done
cmp 1.strad 2.strad
cmp 1.strad 5.strad

# And they are not all the same for another reason: another error gives another solution.
strad-solve -j 1 -e 0.5 --time 2:3 scene.strad >other.strad
if cmp -s 1.strad other.strad; then exit 1; fi
