# Every model imports or is refused with one clear line, as the table in tests/data/import/models.tsv says.
models=$STRAD_SOURCE_DIR/tests/data/models
table=$STRAD_SOURCE_DIR/tests/data/import/models.tsv
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$models"

fail() {
  echo "$1" >&2
  exit 1
}

while IFS=$'\t' read -r file status expected; do
  [[ $file == '#'* ]] && continue
  rm -f "$work/out"
  got=0
  strad-import -v -o "$work/out" "$file" 2> "$work/err" || got=$?
  ((got == status)) || fail "$file: status $got, expected $status: $(cat "$work/err")"
  [[ $(tail -n 1 "$work/err") == "strad-import: $expected" ]] || fail "$file: said: $(cat "$work/err")"
  if ((status == 0)); then
    [[ -s $work/out ]] || fail "$file: wrote nothing"
  else
    (($(wc -l < "$work/err") == 1)) || fail "$file: refused with more than a line: $(cat "$work/err")"
    [[ ! -e $work/out ]] || fail "$file: refused, but something was written"
  fi
done < "$table"

# The table leaves no model out.
find . -type f \( -name '*.obj' -o -name 'clusterfuzz*' \) | sed 's,^\./,,' | LC_ALL=C sort > "$work/found"
grep -v '^#' "$table" | cut -f 1 | LC_ALL=C sort | diff - "$work/found"
