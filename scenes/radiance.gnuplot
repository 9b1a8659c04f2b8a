# Radiance over time as strad-probe writes it: m1.tsv, m2.tsv, smooth.tsv to radiance.png.
set terminal pngcairo size 960,540
set output "radiance.png"
set xlabel "time, s"
set ylabel "radiance from indirect light (green), W / (sr m^2)"
set key top center
plot "m1.tsv" using 1:5 with lines lc rgb "#c04040" title "constant (M1), as solved", \
     "m2.tsv" using 1:5 with lines lc rgb "#4060c0" title "linear (M2), as solved", \
     "smooth.tsv" using 1:5 with lines lc rgb "#000000" title "the default (M3), as frames show it"
