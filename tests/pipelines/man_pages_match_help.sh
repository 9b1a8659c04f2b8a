# Every option that --help shows is in the tool's man page, and the other way round.
cd "$STRAD_SOURCE_DIR"
source tests/pipelines/options_of_help.bash

status=0
for tool in tools/strad-*.cpp; do
  tool=$(basename "$tool" .cpp)
  page=man/$tool.1
  help=$(options_of_help "$tool")
  # Those that the page defines: ".It Fl f , Fl -frames Ar FRAMES".
  page_options=$(sed -nE 's/^\.It (Fl .*)/\1/p' "$page" | grep -oE 'Fl [^ ]+' | sed 's/^Fl /-/' | sort -u)
  diff <(echo "$help") <(echo "$page_options") || {
    echo "$tool: < in --help only, > in $page only"
    status=1
  }
done
exit $status
