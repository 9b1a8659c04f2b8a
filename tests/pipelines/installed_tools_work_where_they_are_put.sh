# What `make install DESTDIR=... PREFIX=...` puts there works there: the tools, the module they load, the man pages.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

DESTDIR=$PWD cmake --install "$STRAD_BUILD_DIR" --prefix /opt/strad >log
for source in "$STRAD_SOURCE_DIR"/tools/strad-*.cpp; do
  tool=$(basename "$source" .cpp)
  opt/strad/bin/$tool --version >/dev/null
  test -s opt/strad/share/man/man1/$tool.1
  test -s opt/strad/share/bash-completion/completions/$tool
  test -s opt/strad/share/zsh/site-functions/_$tool
done
test -s opt/strad/share/man/man5/strad.5
test -s opt/strad/share/man/man7/strad.7

# Pictures other than PPM and PFM need the module.
printf 'P6\n1 1\n255\nabc' >a.ppm
opt/strad/bin/strad-diff a.ppm a.ppm --image heat.png
opt/strad/bin/strad-diff heat.png heat.png | grep -x 'rel_rmse 0'
