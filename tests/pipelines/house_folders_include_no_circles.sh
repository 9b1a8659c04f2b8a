# No two files include each other (a header and its source are one), and no folders of lib/ include in a circle.
cd "$STRAD_SOURCE_DIR/lib"

# Lines `A B`: the file A includes the file B.
includes=$(grep -roE '^#include "[^"]+"' . --include='*.h' --include='*.cpp' |
  sed -E 's,^\./([^:]*):#include "([^"]*)",\1 \2,')
[ "$(wc -l <<<"$includes")" -gt 100 ] || { echo "found too few includes: $includes"; exit 1; }

status=0
mutual=$(sed -E 's/\.(h|cpp)\b//g' <<<"$includes" | sort -u |
  awk '$1 != $2 { if (($2, $1) in seen) print $1, $2; seen[$1, $2] }')
[ -z "$mutual" ] || { echo "these include each other:"; echo "$mutual"; status=1; }

# What stands above a folder may use it and be used by it: solve/solve.cpp runs the phases, which read solve/solve.h.
folders=$(sed -E 's,/[^/ ]* , ,; s,/[^/ ]*$,,' <<<"$includes" | sort -u |
  awk '$1 != $2 && index($1, $2 "/") != 1 && index($2, $1 "/") != 1')
circles=$(tsort <<<"$folders" 2>&1 >/dev/null) || { echo "these folders include in a circle:"; echo "$circles"; status=1; }
exit $status
