# mandoc finds no fault in any page, every tool has one, and every page that one refers to is there.
cd "$STRAD_SOURCE_DIR"

mandoc -T lint -W warning man/*.[157]
for tool in tools/strad-*.cpp; do
  test -s "man/$(basename "$tool" .cpp).1" || { echo "no page for $tool"; exit 1; }
done
for page in strad.5 strad.7 strad-motion.5; do
  test -s "man/$page" || { echo "no page $page"; exit 1; }
done
grep -hoE '^\.Xr strad[a-z-]* [157]' man/*.[157] | sort -u | while read -r _ name section; do
  test -s "man/$name.$section" || { echo "no page $name($section)"; exit 1; }
done
