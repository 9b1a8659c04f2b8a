# lib/README.md says who may include whom ("- `frame/` may include `solve/` ..."); the sources keep to it.
cd "$STRAD_SOURCE_DIR/lib"

status=0
for floor in */; do
  floor=${floor%/}
  rule=$(grep -E "^- \`$floor/\` (may include|includes nothing)" README.md) || {
    echo "lib/README.md: no rule for $floor/"
    exit 1
  }
  for other in $(grep -rhoE '#include "[a-z_]+/' "$floor" | sed 's/.*"//' | sort -u); do
    [ "$other" = "$floor/" ] || grep -qF "\`$other\`" <<<"${rule#*\`*\`}" || {
      echo "lib/$floor includes $other:"
      grep -rn "#include \"$other" "$floor"
      status=1
    }
  done
done
# Within solve/ each folder may include those before it.
for folder in solve/*/; do
  rule=$(grep -E "^- \`$folder\` (may include|includes no)" README.md) || { echo "lib/README.md: no rule for $folder"; exit 1; }
  for other in $(grep -rhoE '#include "solve/[a-z_]+[/.]' "$folder" | sed 's/.*"//' | sort -u); do
    [ "$other" = "$folder" ] || grep -qF "\`$other\`" <<<"${rule#*\`*\`}" || {
      echo "lib/$folder includes $other:"
      grep -rn "#include \"$other" "$folder"
      status=1
    }
  done
done
exit $status
