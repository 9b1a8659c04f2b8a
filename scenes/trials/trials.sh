#!/bin/bash
# Small scenes, each of a kind that is hard for a solver: light through two doors, small things in a large hall, thin bars,
# fast motion, a curved body that turns, light through a slit.
#
#   trials.sh doors|belt|beams|fan|statue|slit FOLDER     writes FOLDER/NAME.obj, NAME.mtl and NAME.motion, where NAME is
#                                                         the folder's own name
set -eu -o pipefail
export LC_ALL=C
here=$(cd "$(dirname "$0")" && pwd)

if [ $# -ne 2 ] || [[ ! $1 =~ ^(doors|belt|beams|fan|statue|slit)$ ]]; then
  echo "usage: trials.sh doors|belt|beams|fan|statue|slit FOLDER" >&2
  exit 2
fi
mkdir -p "$2"
name=$2/$(basename "$(cd "$2" && pwd)")

awk -v kind="$1" -v library="$(basename "$name").mtl" \
  -f "$here/../halls/solids.awk" -f "$here/../complex/turned.awk" -f "$here/trials.awk" >"$name.obj"
cp "$here/trials.mtl" "$name.mtl"

case $1 in
  doors) cat <<'END' ;;
# doors: the door in the first wall opens and closes half
time 0 6
rate 25

body door
  parts door
  pivot 3 2.61 0
  axis 0 0 1
  key 0 turn 0
  key 4 turn 80
  key 6 turn 40

camera main
  key 0 from 6.3 3.7 1.6 to 8.5 1.5 0.9 up 0 0 1 fov 70
END
  belt)
    echo "# belt: parcels ride on the belt"
    echo "time 0 6"
    echo "rate 25"
    for i in 0 1 2 3 4 5; do
      printf '\nbody parcel%d\n  parts parcel%d\n  key 0 move 0 0 0\n  key 6 move 2.2 0 0\n' "$i" "$i"
    done
    printf '\ncamera main\n  key 0 from 1 6.5 2.4 to 5 2.6 0.7 up 0 0 1 fov 60\n'
    ;;
  beams) cat <<'END' ;;
# beams: the lamp slides below the trusses
time 0 6
rate 25

body lamp
  parts lamp
  key 0 move 0 0 0
  key 6 move 4 0 0

camera main
  key 0 from 0.4 0.3 1.6 to 3.6 3 2.2 up 0 0 1 fov 68
END
  fan) cat <<'END' ;;
# fan: twice a turn a second
time 0 2
rate 25

body fan
  parts fan
  pivot 2.5 2 0
  axis 0 0 1
  key 0 turn 0
  key 2 turn 1440

camera main
  key 0 from 0.4 0.4 1.8 to 3 2.4 1.2 up 0 0 1 fov 75
END
  statue) cat <<'END' ;;
# statue: half a turn
time 0 6
rate 25

body statue
  parts statue
  pivot 2 2 0
  axis 0 0 1
  key 0 turn 0
  key 6 turn 180

camera main
  key 0 from 0.5 0.4 1.7 to 2.2 2.2 1.1 up 0 0 1 fov 55
END
  slit) cat <<'END' ;;
# slit: a spotlight swings over the slit
time 0 6
rate 25

spot lamp
  cone 20 35
  key 0 at 0.6 1 1.6 aim 2.5 2 1 intensity 80 75 65
  key 6 at 0.6 3 1.6 aim 2.5 2 1 intensity 80 75 65

camera main
  key 0 from 5.7 0.4 1.6 to 3 2.6 0.9 up 0 0 1 fov 72
END
esac >"$name.motion"
