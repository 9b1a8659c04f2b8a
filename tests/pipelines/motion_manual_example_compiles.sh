# The example of strad-motion(5) is a motion file for a scene that has its objects and its material.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

sed -n '/^\.Sh EXAMPLES/,/^\.Ed/p' "$STRAD_SOURCE_DIR/man/strad-motion.5" | sed '1,/^\.Bd/d; /^\.Ed/d' >example.motion
grep -q '^camera main' example.motion

printf 'newmtl plain\nKd 0.5 0.5 0.5\nnewmtl lampmat\nKe 1 1 1\n' >example.mtl
{
  echo 'mtllib example.mtl'
  for object in floor crane_mast crane_arm hook lamp; do
    echo "o $object"
    [ $object = lamp ] && echo 'usemtl lampmat' || echo 'usemtl plain'
    printf 'v 0 0 0\nv 1 0 0\nv 0 0 1\nf -3 -2 -1\n'
  done
} >example.obj
strad-import example.obj | strad-motion example.motion | strad-info >info
grep -q 'frames: 600' info
grep -q 'name crane, on rail, objects 2' info
grep -q 'name hook, on crane, objects 1' info
