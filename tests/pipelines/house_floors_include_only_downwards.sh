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
exit $status
