# --help and --version succeed; an unknown option or a missing file is one clear line and status 2.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

for source in "$STRAD_SOURCE_DIR"/tools/strad-*.cpp; do
  tool=$(basename "$source" .cpp)
  "$tool" --help | grep -e --version >/dev/null
  [[ $("$tool" --version) =~ ^$tool\ [0-9]+\.[0-9]+\.[0-9]+$ ]]
  for arguments in --no-such-option 'missing.strad missing.strad'; do
    status=0
    "$tool" $arguments </dev/null >out 2>err || status=$?
    if [ $status != 2 ] || [ -s out ] || [ "$(wc -l <err)" != 1 ] || ! grep -q "^$tool: " err; then
      echo "$tool $arguments: exit status $status"
      cat out err
      exit 1
    fi
  done
done
