# lib/README.md lists every file of lib/, and no other.
cd "$STRAD_SOURCE_DIR/lib"

listed=$(sed -nE 's/^\| `([^`]*\.(h|cpp))`.*/\1/p' README.md | sort)
# A header and the source beside it are one entry, that of the header.
found=$(find . -name '*.h' -o -name '*.cpp' | sed 's|^\./||' | sort |
  while read -r file; do
    [[ $file == *.cpp && -e ${file%.cpp}.h ]] || echo "$file"
  done)
diff <(echo "$listed") <(echo "$found") || { echo "< in lib/README.md only, > in lib/ only"; exit 1; }
