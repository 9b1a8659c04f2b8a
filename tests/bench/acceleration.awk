# First file: -e, CPU s of an instant, its error. Second: CPU s of the space-time solve, its error. Prints for each line
# of the second how many times longer `total` instants of equal error take, by interpolation in logarithms; outside the
# measured errors the nearest two instants are continued.
FNR == NR { cost[++n] = log($2); rel[n] = log($3); next }
n >= 2 {
  x = log($2)
  for (i = 1; i < n - 1 && x < rel[i + 1]; ++i);
  slope = rel[i + 1] == rel[i] ? 0 : (cost[i + 1] - cost[i]) / (rel[i + 1] - rel[i])
  printf "%9s %9s %9.1f\n", $2, $1, total * exp(cost[i] + slope * (x - rel[i])) / $1
}
