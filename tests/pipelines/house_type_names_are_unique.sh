# A type of namespace strad is defined once in lib/. Two of one name in two files break the one definition rule, and
# linkers rarely notice (-Wodr only when a program uses both). Types in anonymous namespaces are their file's own.
cd "$STRAD_SOURCE_DIR/lib"

# The sources are laid out by clang-format: a type at namespace level starts in the first column.
types=$(find . -name '*.h' -o -name '*.cpp' | sort | xargs awk '
  FNR == 1 { own = 0 }
  /^namespace \{/ { own = 1 }
  /^}  \/\/ namespace$/ { own = 0 }
  !own && /^(template <.*> )?(struct|class|enum|union) .*\{/ {
    sub(/^template <.*> /, "")
    sub(/^enum (class|struct) /, "enum ")
    split($0, words, /[ ;{<]+/)
    if (words[2] !~ /::/) print words[2], substr(FILENAME, 3)  # else a member, defined outside of its class
  }' | sort)
[ "$(wc -l <<<"$types")" -gt 50 ] || { echo "found too few types: $types"; exit 1; }
twice=$(cut -d' ' -f1 <<<"$types" | uniq -d)
for type in $twice; do
  echo "$type is defined in:" $(grep "^$type " <<<"$types" | cut -d' ' -f2)
done
[ -z "$twice" ]
