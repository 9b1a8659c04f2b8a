# 0: within the limits, 1: differs, 2: trouble, in one clear line.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

expect() {  # expect STATUS ARGUMENTS...
  local wanted=$1 found=0
  shift
  strad-diff "$@" >out 2>err || found=$?
  if [ $found != "$wanted" ]; then
    echo "strad-diff $*: exit status $found, expected $wanted"
    cat out err
    exit 1
  fi
  if [ "$wanted" = 2 ]; then
    test ! -s out
    test "$(wc -l <err)" = 1
    grep -q '^strad-diff: ' err
  else
    test ! -s err
  fi
}

one='\0\0\200\077' half='\0\0\0\077' nan='\0\0\300\177' inf='\0\0\200\177'
printf "PF\n1 1\n-1\n$one$one$one" >a.pfm
printf "PF\n1 1\n-1\n$one$one$half" >b.pfm
printf "PF\n1 1\n-1\n$one$one$nan" >nan.pfm
printf "PF\n1 1\n-1\n$inf$one$one" >inf.pfm
printf "PF\n1 2\n-1\n$one$one$one$one$one$one" >tall.pfm

expect 0 a.pfm a.pfm
expect 1 a.pfm b.pfm
expect 0 a.pfm b.pfm --max 0.5
expect 1 a.pfm b.pfm --max 0.49
expect 0 a.pfm b.pfm --rel-rmse 0.289  # sqrt(0.25 / 3) = 0.28868
expect 1 a.pfm b.pfm --rel-rmse 0.288
expect 1 a.pfm b.pfm --rel-rmse 0.289 --max 0.1
expect 2 a.pfm
expect 2 a.pfm missing.pfm
expect 2 a.pfm tall.pfm
expect 2 a.pfm nan.pfm
expect 2 inf.pfm a.pfm
expect 2 a.pfm b.pfm --max nan
expect 2 a.pfm b.pfm --max
expect 2 a.pfm b.pfm --unknown
expect 2 a.pfm b.pfm --image heat.unknown
expect 2 a.pfm b.pfm --flicker 1
expect 2 a.pfm b.pfm --frames 1:2
expect 2 --jump 1 a.pfm

# A heat map appears, also when the pictures differ.
expect 1 a.pfm b.pfm --image heat.png
test -s heat.png
