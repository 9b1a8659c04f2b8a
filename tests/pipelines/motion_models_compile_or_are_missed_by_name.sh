# The scene of other people's models compiles where their packages are installed, each in its place; where not, one line
# names a file that is missing and nothing is written.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
models=$STRAD_SOURCE_DIR/scenes/models/models.sh

status=0
ASSIMP_MODELS=$PWD/none "$models" a/models 2>err || status=$?
[ $status = 2 ]
[ "$(wc -l <err)" = 1 ]
grep -q "$PWD/none/.*assimp-testmodels" err
[ ! -e a ]

# The same from models of our own, a tetrahedron each: what a model's file says is taken, not its size.
mkdir -p assimp povray/camera/mesh_camera
printf '%s\n' $'usemtl R\303\270d' 'v 0 0 0' 'v 30 0 0' 'v 0 30 0' 'v 0 0 30' 'f 1 3 2' 'f 1/1 2/2 4/3' 'f 2 3 4' 'f 3//1 1//2 4//3' >assimp/spider.obj
cp assimp/spider.obj assimp/WusonOBJ.obj
cp assimp/spider.obj assimp/regr01.obj
printf 'newmtl R\303\270d\r\nKd 0.5 0.25 0.125\r\n' | tee assimp/spider.mtl >assimp/regr01.mtl
cat >povray/camera/mesh_camera/vase1.inc <<'END'
#declare vase = mesh2{
 vertex_vectors { 4, <0, 0, 0>, <3, 0, 0>, <0, 3, 0>,
  <0, 0, 3>}
 normal_vectors { 1, <1, 0, 0>}
 texture_list { 1, texture{t}}
 face_indices { 4, <0, 1, 2>, 0, <0, 3, 1>, 0,
  <1, 3, 2>, 0, <2, 3, 0>, 0}
 normal_indices { 1, <0, 0, 0>}
}
END
cp povray/camera/mesh_camera/vase{1,2}.inc
ASSIMP_MODELS=$PWD/assimp POVRAY_SCENES=$PWD/povray "$models" own
[ "$(grep -c '^f' own/own.obj)" = $((6 + 7 + 63 + 48 + 5 * 4)) ]
for file in own/own.obj $([ -d /usr/share/assimp/models/OBJ ] && [ -d /usr/share/doc/povray/examples/camera ] && "$models" real && echo real/real.obj); do
  strad-import -q $file | strad-motion ${file%.obj}.motion | strad-info >info
  grep -q 'name beast, on world, objects 1' info
  grep -q 'lower: 0 0 -0.002' info
  grep -q 'upper: 8 6 3.2' info
done
strad-import -q own/own.obj | strad-info >info
grep -q 'name spider_R__d, reflectance 0.5 0.25 0.125' info

# Outward stays outward, from right- and left-handed files: all five volumes are positive.
awk '
  $1 == "o" { object = $2 }
  $1 == "v" { x[++v] = $2; y[v] = $3; z[v] = $4 }
  $1 == "f" && $2 < 0 {
    a = v + 1 + $2; b = v + 1 + $3; c = v + 1 + $4
    six[object] += x[a] * (y[b] * z[c] - z[b] * y[c]) + y[a] * (z[b] * x[c] - x[b] * z[c]) + z[a] * (x[b] * y[c] - y[b] * x[c])
  }
  END { for (o in six) if (six[o] > 0.01) ++positive; exit positive != 5 }' own/own.obj
