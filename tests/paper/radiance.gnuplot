# Radiance over time at a point (strad-probe's tables in `folder`) as SVG: all `seconds`, and a piece around `half`.
set terminal svg size 960,400 font "sans-serif,13" background "white"
set xlabel "time, s"
set ylabel "radiance (green), W / (sr m^2)" noenhanced
set key top left
red = "#c8323c"
blue = "#2850b4"

set output folder."/radiance.svg"
set xrange [half - seconds / 2.0:half + seconds / 2.0]
plot folder."/radiance-reference.tsv" using 1:5 with lines lw 4 lc rgb "#c0c0c0" title "reference", \
     folder."/radiance-m1.tsv" using 1:5 with lines lc rgb red title "constant (Haar)", \
     folder."/radiance-m2.tsv" using 1:5 with lines lc rgb blue title "M2"

set output folder."/radiance-half.svg"
set xrange [half - seconds / 16.0:half + seconds / 16.0]
replot
