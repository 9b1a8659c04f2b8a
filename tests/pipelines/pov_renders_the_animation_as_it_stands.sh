# `povray room.ini` renders all frames, from the folder that strad-frame was called in and from that of the files.
room=$STRAD_SOURCE_DIR/tests/pipelines/pov_room
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

strad-import "$room/room.obj" | strad-motion "$room/room.motion" | strad-solve -e 0.5 >room.strad
mkdir files
strad-frame -f 8:10 -s 32x24 --pov -o 'files/room.%04d.inc' room.strad
diff <(ls files) - <<'END'
room.0008.inc
room.0009.inc
room.0010.inc
room.ini
room.pov
room_geometry.inc
room_texture1.ppm
END
povray files/room.ini >log 2>&1 || { cat log; exit 1; }
ls room08.png room09.png room10.png >/dev/null
(cd files && povray room.ini +SF10 +EF10 >../log 2>&1) || { cat log; exit 1; }
same() { strad-diff --max 0 "$1" "$2" || { echo "$1 is not $2"; exit 1; }; }  # PNG files hold the time
same files/room10.png room10.png
# The scene alone shows the first frame; a still needs no number.
povray files/room.pov +Lfiles +W32 +H24 +AM2 +A0.1 +R4 -J -D +Oalone.png >log 2>&1 || { cat log; exit 1; }
same alone.png room08.png
strad-frame -t 0.7 -s 32x24 --pov -o still.inc room.strad
povray still.ini +Ostill.png >log 2>&1 || { cat log; exit 1; }
same still*.png room08.png
# Warnings would drown the user's own.
if grep -i warning: log; then exit 1; fi
