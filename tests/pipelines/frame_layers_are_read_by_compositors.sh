# strad-frame --layers: one EXR file with the layers asked for, under names that compositors know, whose light adds up.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
scene=$STRAD_SOURCE_DIR/scenes/cornell/cornell

strad-import -q $scene.obj | strad-motion $scene.motion | strad-solve -q -e 0.3 --time 2:2.4 >solved.strad
frame() { strad-frame -q -s 48x48 "$@" solved.strad; }

frame -f 55 --layers all --depth float -o all.exr
oiiotool --info -v all.exr >told
channels='R, G, B, CryptoMaterial00.R, CryptoMaterial00.G, CryptoMaterial00.B, CryptoMaterial00.A'
grep -qF "channel list: $channels" told || { cat told; exit 1; }
for name in direct.R indirect.G emission.B albedo.R normal.X position.Z depth.Z forward.u backward.v CryptoObject02.A; do
  grep -qF "$name" told || { echo "no channel $name in"; cat told; exit 1; }
done
# Keys of the specification; the manifest names the objects of the scene.
grep -qE 'cryptomatte/[0-9a-f]{7}/hash: "MurmurHash3_32"' told
grep -qE 'cryptomatte/[0-9a-f]{7}/manifest: ".*tall.*' told

# The main layer is the picture that is made without --layers.
frame -f 55 --depth float -o alone.exr
strad-diff alone.exr all.exr --max 0 >/dev/null
for part in direct indirect emission; do
  oiiotool all.exr --ch R=$part.R,G=$part.G,B=$part.B -o $part.exr
done
oiiotool direct.exr indirect.exr --add emission.exr --add -o sum.exr
strad-diff all.exr sum.exr --max 1e-5 >/dev/null
# None of the parts is missing: the lamp shows, and both kinds of light are more than a tenth of the whole.
for part in direct indirect emission; do
  strad-diff all.exr $part.exr >means || true  # they differ
  awk '$1 == "mean_b" && $2 > 0.02 { found = 1 } END { exit !found }' means
done

# A matte covers a pixel by 0 to 1, and all mattes of a closed room together cover it fully.
oiiotool all.exr --ch R=CryptoObject00.G,G=CryptoObject00.A,B=CryptoObject01.G -o cover.exr
oiiotool cover.exr --chsum -o covered.exr
oiiotool --stats covered.exr | grep -q 'Stats Avg: 1.0'

# Pictures of their own for other formats.
mkdir png
frame -f 55:56 --layers combined,direct,normal -o 'png/f.%03d.png'
[ "$(ls png | tr '\n' ' ')" = 'f.combined.055.png f.combined.056.png f.direct.055.png f.direct.056.png f.normal.055.png f.normal.056.png ' ]
frame -f 55 -o alone.png
# The same picture; what was asked for stands in its texts.
oiiotool alone.png png/f.combined.055.png --diff >/dev/null

refused() {  # refused TEXT ARGUMENTS...
  local status=0 text=$1
  shift
  frame -f 55 "$@" >out 2>err || status=$?
  if [ $status != 2 ] || [ "$(wc -l <err)" != 1 ] || ! grep -qF -e "$text" err || [ -s out ]; then
    echo "strad-frame $*: exit status $status, expected 2 and: $text"
    cat err
    exit 1
  fi
}
refused "--layers: found 'shadow', expected some of all, combined" --layers shadow -o x.exr
refused '--layers: found depth, expected EXR files for it' --layers depth -o x.png
refused "--layers: expected -o PATTERN" --layers depth
refused '--layers: for pictures of the solution' --layers depth --reference 1 -o x.exr
[ ! -e x.exr ] && [ ! -e x.png ]
