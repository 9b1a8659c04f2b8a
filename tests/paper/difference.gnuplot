# The difference of two pictures as difference.awk tells it (`data`, of `columns` by `rows`), to the PNG `picture`: the
# darker, the larger, as in figure 4 of the paper. All pictures have the same scale.
set terminal pngcairo size columns + 70, rows font ",9"
set output picture
set palette defined (0 "white", 0.25 "#ffd27f", 0.5 "#e0653a", 0.75 "#7a1f4f", 1 "black")
set cbrange [0:10]
set cbtics format "%g %%"
set colorbox user origin screen columns / (columns + 70.0) + 0.02, screen 0.05 size screen 0.03, screen 0.9
set lmargin at screen 0
set rmargin at screen columns / (columns + 70.0)
set tmargin at screen 1
set bmargin at screen 0
unset tics
unset key
set cbtics
set xrange [-0.5:columns - 0.5]
set yrange [-0.5:rows - 0.5]
plot data using 1:2:3 with image
