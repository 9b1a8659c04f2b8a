# An .ini file says which frames, at which clocks, of which size, with which declarations and folders; the file sees them
# as in POV-Ray.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
mkdir parts

# A box of 1 m that is where the constants say.
echo '#default { pigment { rgb 0.5 } }' >parts/look.inc
cat >s.pov <<'END'
#include concat(Look, ".inc")
box { 0, 9 }
box { 0, 1 translate <clock, frame_number, clock_delta> }
box { 0, 1 translate <0, Up, final_frame + final_clock> }
END
cat >s.ini <<'END'
; comment
Input_File_Name = "s.pov"
Library_Path=parts
Declare=Up=7
Declare=Look=look
Width=300 ; pixels
Height=100
Antialias=On
Initial_Frame=10
Final_Frame=14
Initial_Clock=2
Final_Clock=4
[large]
Width=ignored
END
print() { strad-import -q "$@" | strad-motion --print; }
# Five frames: the clock goes 2, 2.5, ..., 4, the frame number 10 to 14; the third component, clock_delta, stays.
print s.ini >motion
grep -qx 'time 0 0.2' motion
grep -qx '  key 0.16  move 2 4 0' motion
[ "$(grep -c '^body' motion)" = 1 ]
strad-import -q s.ini | strad-info --objects >info
# z is mirrored: 14 + 4 = 18 becomes -18, and the box goes on to -19; clock_delta 0.5 becomes -0.5.
grep -q 'lower 0 7 -19, upper 1 8 -18' info
grep -q 'lower 2 10 -1.5, upper 3 11 -0.5' info

# Cyclic: the clock would be 4 in the frame after the last; 2 / 5 a frame.
{ sed '/large/,$d' s.ini; echo 'Cyclic_Animation=On'; } >cyclic.ini
print cyclic.ini | grep -x '  key 0.16  move 1.6 4 0' >/dev/null
# A part of the frames begins at 0 s: 11 to 13, by numbers or by parts of the final frame (0.8 * 14 and 0.95 * 14, rounded
# down, as POV-Ray 3.7 does), and by switches.
{ sed '/large/,$d' s.ini; printf 'Subset_Start_Frame=11\nSubset_End_Frame=13\n'; } >subset.ini
print subset.ini >subset
grep -qx 'time 0 0.12' subset
grep -qx '  key 0.08  move 1 2 0' subset
{ sed '/large/,$d' s.ini; printf 'Subset_Start_Frame=0.8\nSubset_End_Frame=0.95\n'; } >subset.ini
print subset.ini | cmp - subset
printf '+Is.pov +Lparts +KFI10 +KFF14 +KI2 +KF4 +SF11 +EF13 +W300 +H100 -D\nDeclare=Up=7\nDeclare=Look=look\n' >switches.ini
print switches.ini | cmp - subset
# Options win over the file; without one they are enough.
print --rate 24000/1001 s.ini | grep -x 'rate 24000/1001' >/dev/null
sed -i 's/Up/7/; s/#include.*/#default { pigment { rgb 0.5 } }/' s.pov
print --frames 10:14 --clock 2:4 s.pov | cmp - motion
