# Of lines `red green blue red green blue`, a pixel of two pictures each, from below: column, row and the mean absolute
# difference of the channels, in percent of the mean of the first picture.
{
  for (c = 1; c <= 3; ++c) {
    sum += $c
    difference[NR] += $c > $(c + 3) ? $c - $(c + 3) : $(c + 3) - $c
  }
}
END {
  scale = sum > 0 ? 100 * NR / sum : 0
  for (i = 1; i <= NR; ++i) printf "%d\t%d\t%.3f\n", (i - 1) % columns, int((i - 1) / columns), scale * difference[i]
}
