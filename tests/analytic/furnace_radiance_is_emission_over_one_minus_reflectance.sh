# A closed box in which every surface emits Le = 1 and reflects rho = 0.5: L = Le / (1 - rho) = 2 and E = pi L at
# every point and time, within 1 %; also with a box that turns and moves in it, and on that box.
here=$STRAD_SOURCE_DIR/tests/analytic
. "$here/judge.bash"
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

cat >points <<'END'
2    1.5  0
0.05 0.05 0
1    0    1
4    2.9  1.9
1.8  0.3  2
3.1  3    0.2
0    1.5  1
END
cat >on_box <<'END'
1    1    0.6
1.4  1    1
0.65 0.65 1.4
END
law='{ for (c = 4; c <= 6; c++) judge($c, 2, 0.02); for (c = 7; c <= 9; c++) judge($c, 6.283185307, 0.0628) }'

solve() {
  strad-import "$STRAD_SOURCE_DIR/scenes/$1/$1.obj" | strad-motion "$STRAD_SOURCE_DIR/scenes/$1/$1.motion" |
    strad-solve >$1.strad
}

solve furnace
for direct in pixel mesh; do
  strad-probe -n 3 --direct $direct --points points furnace.strad >table
  judge "furnace, direct light by $direct" "$law" table
done

solve furnace_moving
cat on_box >>points
strad-probe -n 17 --points points furnace_moving.strad >table
judge 'furnace with a moving box' "$law" table

# Its mesh holds the shadows that the box draws on walls close by to 4 % at a time, their mean to 1 %.
strad-probe -n 17 --direct mesh --points points furnace_moving.strad >table
judge 'furnace with a moving box, direct light by mesh' '
  { judge($4, 2, 0.08); sum[$2] += $4; count[$2]++ }
  END { for (point in sum) judge(sum[point] / count[point], 2, 0.02) }' table
