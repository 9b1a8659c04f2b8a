# Whatever fails or ends a tool, at whichever of its system calls: its output is the right file, or what was there
# before; it says so in one line with status 2; and nothing is left beside it, but by kill -9, and that is cleared by the
# next run. strace injects the faults.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
strace -o /dev/null true 2>/dev/null || { echo "strace cannot be used here"; exit 0; }
if ldd "$(command -v strad-import)" | grep -qE 'lib(asan|tsan|ubsan)'; then
  echo "sanitizers do not work under strace"
  exit 0
fi

scene=$STRAD_SOURCE_DIR/scenes/shutter/shutter
cp $scene.obj a.obj
cp "$(dirname $scene)"/*.mtl . 2>/dev/null || true
strad-import a.obj -o a.strad
strad-motion $scene.motion a.strad -o b.strad
strad-solve -j 1 -e 0.5 b.strad -o c.strad
mkdir out
echo old >old

# What each tool does with -o FILE, and what is then in FILE.
commands=(
  'strad-import a.obj -o FILE'
  "strad-motion $scene.motion a.strad -o FILE"
  'strad-solve -j 1 -q -e 0.5 b.strad -o FILE'
  'strad-frame -j 1 -f 1 -s 16x12 c.strad -o FILE.png'
  'strad-frame -j 1 -f 1 -s 16x12 c.strad -o FILE.exr'
  'strad-frame -j 1 -f 1 --ply c.strad -o FILE.ply'
  'strad-probe -j 1 -n 2 -q --at 0,0,0 c.strad -o FILE'
  'strad-join c.strad -o FILE'
  'strad-info c.strad -o FILE'
)
calls=write,fsync,rename,fchmod,fchown

injected=0
# inject FAULT: runs $command with the fault injected; its status is in $status.
inject() {
  status=0
  { strace -f -qq -o trace -e trace=$calls -e inject="$1" $command 2>err || status=$?; } 2>/dev/null
  injected=$((injected + 1))
}
failed() {
  echo "$command, $1: status $status"
  cat err
  ls -la out
  exit 1
}
# The output is as it was before, "old", or the right one; nothing else is there.
check_output() {
  [ "$(ls -A out)" = "$(basename "$file")" ] || failed "$1"
  cmp -s "$file" old || cmp -s "$file" right || failed "$1"
}

for command in "${commands[@]}"; do
  file=out/x$(sed -n 's/.*FILE\([.a-z]*\).*/\1/p' <<<"$command")
  command=${command/FILE/out\/x}
  $command 2>/dev/null
  mv "$file" right
  for call in ${calls//,/ }; do
    # So many times it is called when all goes well; then once more, so that the last fault strikes nothing.
    cp old "$file"
    strace -f -qq -o trace -e trace=$call $command 2>/dev/null
    count=$(grep -c "$call(" trace || true)
    for n in $(seq 1 "$count"); do
      for fault in error=EIO error=ENOSPC signal=SIGTERM signal=SIGINT signal=SIGKILL; do
        [[ $call-$fault != fchown-error* ]] || continue  # a file that cannot be given away is kept
        cp old "$file"
        inject "$call:$fault:when=$n"
        case $fault in
          error*)
            [ $call-$n != fsync-2 ] || continue  # of the folder: the file is whole
            [ $status = 2 ] && [ "$(wc -l <err)" = 1 ] && cmp -s "$file" old || failed "$call $n $fault"
            ;;
          signal=SIGKILL)
            [ $status = 137 ] || failed "$call $n $fault"
            $command 2>/dev/null  # clears what was left
            cmp -s "$file" right || failed "$call $n $fault, run again"
            ;;
          *)
            [ $status = 143 ] || [ $status = 130 ] || failed "$call $n $fault"
            ;;
        esac
        check_output "$call $n $fault"
      done
    done
    # A disk that is full from the n-th write on.
    [ $call = write ] || continue
    for n in $(seq 1 "$count"); do
      cp old "$file"
      inject "write:error=ENOSPC:when=$n+"
      [ $status = 2 ] || failed "disk full from write $n"
      check_output "disk full from write $n"
    done
  done
  # Too little memory: whatever becomes of it, nothing half-written and nothing left.
  for kilobytes in 20000 60000 100000 150000 250000; do
    cp old "$file"
    status=0
    { (ulimit -c 0 -v $kilobytes && exec $command) 2>err || status=$?; } 2>/dev/null
    check_output "$kilobytes KB of memory"
  done
  rm -f "$file"
done
echo "$injected faults injected"
