# An outside library's headers are included by exactly one file, which is a .cpp.
cd "$STRAD_SOURCE_DIR"

only() {  # only PATTERN FILES-PATTERN
  local files
  files=$(grep -rlE "#include [<\"]$1" lib tools | sort || true)
  if [ "$(wc -l <<<"$files")" != 1 ] || [[ $files != $2 ]]; then
    echo "$1 is included by:"
    echo "$files"
    echo "expected one file, $2"
    exit 1
  fi
}
only 'embree3/' 'lib/light/*.cpp'
only 'tiny_obj_loader' 'lib/import/obj/*.cpp'
only 'clipper\.hpp' 'lib/import/pov/*.cpp'
only 'ft2build\.h' 'lib/import/pov/*.cpp'
only 'OpenImageIO/' 'lib/image/module/*.cpp'
only 'OpenEXR/' 'lib/image/*.cpp'
only 'png\.h' 'lib/image/*.cpp'
only 'zstd' 'lib/stream/*.cpp'
only 'xxhash' 'lib/stream/*.cpp'
only '(tbb|oneapi)/' 'lib/base/*.cpp'
only 'CLI/' 'tools/tool*.cpp'

# Nothing else from outside: every other <...> is the standard library's, POSIX's or Linux's.
others=$(grep -rhoE '#include <[^>]+/[^>]*>' lib tools | sort -u |
  grep -vE '<(embree3|OpenEXR|OpenImageIO|tbb|oneapi|CLI|sys|immintrin)' || true)
test -z "$others" || { echo "also included: $others"; exit 1; }
