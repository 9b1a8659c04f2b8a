# lib/README.md lists every file of lib/, and no other, with the words that the file begins with.
cd "$STRAD_SOURCE_DIR/lib"

listed=$(sed -nE 's/^\| `([^`]*\.(h|cpp))`.*/\1/p' README.md | sort)
# A header and the source beside it are one entry, that of the header.
found=$(find . -name '*.h' -o -name '*.cpp' | sed 's|^\./||' | sort |
  while read -r file; do
    [[ $file == *.cpp && -e ${file%.cpp}.h ]] || echo "$file"
  done)
diff <(echo "$listed") <(echo "$found") || { echo "< in lib/README.md only, > in lib/ only"; exit 1; }

status=0
while read -r file says; do
  begins=$(awk '!/^\/\/ / { exit } { printf "%s ", substr($0, 4) }' "$file")
  [[ $begins == "$says"[.?:]* ]] || {
    echo "lib/README.md says of $file: $says"
    echo "but the file begins with: $begins"
    status=1
  }
done < <(sed -nE 's/^\| `([^`]*\.(h|cpp))` \| (.*) \|$/\1 \3/p' README.md)
exit $status
