# OpenImageIO and its 261 libraries cost 0.3 s: no tool is linked to them; a module is loaded when a picture is touched.
for source in "$STRAD_SOURCE_DIR"/tools/strad-*.cpp; do
  tool=$(command -v "$(basename "$source" .cpp)")
  if ldd "$tool" | grep OpenImageIO; then
    echo "$tool is linked to it"
    exit 1
  fi
done
ldd "$STRAD_BUILD_DIR/lib/strad/strad-image-files.so" | grep OpenImageIO >/dev/null
