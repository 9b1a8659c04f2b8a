# The first line of a header, or of a source without one, is a comment; so are those of scripts.
cd "$STRAD_SOURCE_DIR"

status=0
while read -r file; do
  case $file in
    *.cpp) [ -e "${file%.cpp}.h" ] && continue ;;
  esac
  line=$(grep -vm1 '^#!' "$file")
  [[ $line == "// "* || $line == "# "* ]] || { echo "$file: found '$line', expected a comment"; status=1; }
done < <(find lib tools tests scenes -name '*.h' -o -name '*.cpp' -o -name '*.sh')
exit $status
