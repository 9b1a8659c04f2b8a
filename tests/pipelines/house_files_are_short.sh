# One noun a file: no tool over 200 lines, no file of the library or its tests over 500.
cd "$STRAD_SOURCE_DIR"

status=0
check() {  # check LIMIT FILES...
  local limit=$1 file
  shift
  for file in "$@"; do
    [ "$(wc -l <"$file")" -le "$limit" ] || {
      echo "$file has $(wc -l <"$file") lines, expected at most $limit"
      status=1
    }
  done
}
check 200 tools/*
mapfile -t files < <(find lib tests -name '*.h' -o -name '*.cpp' -o -name '*.sh')
check 500 "${files[@]}"
exit $status
