# Every option that --help shows is in the tool's man page, and the other way round.
cd "$STRAD_SOURCE_DIR"

status=0
for tool in tools/strad-*.cpp; do
  tool=$(basename "$tool" .cpp)
  page=man/$tool.1
  # Options start a line of the help, or follow a comma there.
  help=$("$tool" --help | sed -nE 's/^ +(-.*)/\1/p' | sed 's/  .*//' | grep -oE '(^|[ ,])--?[A-Za-z0-9][A-Za-z0-9-]*' |
    tr -d ' ,' | sort -u)
  # Those that the page defines: ".It Fl f , Fl -frames Ar FRAMES".
  page_options=$(sed -nE 's/^\.It (Fl .*)/\1/p' "$page" | grep -oE 'Fl [^ ]+' | sed 's/^Fl /-/' | sort -u)
  diff <(echo "$help") <(echo "$page_options") || {
    echo "$tool: < in --help only, > in $page only"
    status=1
  }
done
exit $status
