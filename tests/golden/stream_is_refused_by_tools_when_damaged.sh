# Tools tell one line and exit 2 for a damaged stream or option, and leave no file behind; a closed pipe is no fault.
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
cd "$work"
grep -v '^#' "$STRAD_SOURCE_DIR/tests/golden/stream-1.hex" | tr -d '\n' |
  sed 's/../\\x&/g' | xargs -0 printf '%b' >whole.strad

refused() {  # refused EXPECTED COMMAND...
  local expected=$1 status=0
  shift
  "$@" >out 2>err || status=$?
  [[ $status == 2 && $(wc -l <err) == 1 && $(<err) == *"$expected"* && ! -s out ]] || {
    echo "$*: status $status, expected 2 and a line with '$expected', found:"
    cat err
    exit 1
  }
}

strad-info whole.strad >facts
grep -q 'strad-import 0.1.0 tent.obj' facts
strad-info <whole.strad | cmp - facts
cat whole.strad | strad-info - | cmp - facts
strad-join whole.strad | strad-info --chunks | grep '^  strad-join [0-9.]* whole.strad$' >/dev/null

head -c 700 whole.strad >cut.strad
(cat whole.strad; echo) >long.strad
(head -c 400 whole.strad; echo; tail -c +402 whole.strad) >flipped.strad
size=$(stat -c %s whole.strad)
refused 'cut.strad: byte 700:' strad-info cut.strad
refused "long.strad: byte $size: found bytes after" strad-info long.strad
refused 'flipped.strad: byte ' strad-info flipped.strad
refused 'absent.strad: cannot be opened' strad-info absent.strad
refused ': is a directory' strad-info .
refused '--bogus' strad-info --bogus
refused 'whole.strad' strad-join whole.strad whole.strad  # overlap in time
refused 'byte 700' strad-join -o joined.strad cut.strad
refused 'absent/joined.strad' strad-join -o absent/joined.strad whole.strad
[ "$(ls -A | grep -c joined)" = 0 ]

strad-join -o joined.strad whole.strad
strad-join whole.strad | cmp - joined.strad
(
  status=0
  sleep 0.2
  strad-info whole.strad 2>err || status=$?
  echo $status >status
) | true || true
[[ $(<status) == 141 && ! -s err ]]  # SIGPIPE, without a message
