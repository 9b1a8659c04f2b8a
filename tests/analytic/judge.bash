# judge NAME PROGRAM TABLE: runs an awk program over the lines of a strad-probe table (time point object r g b er
# eg eb). The program calls judge(got, want, tolerance) for each value that it knows. Fails, with the worst
# deviation and its line, when one is off by more than its tolerance or none was judged.
judge() {
  awk -v name="$1" '
    function judge(got, want, tolerance,    off) {
      off = (got - want) / tolerance
      if (off < 0) off = -off
      if (judged++ == 0 || !(off <= worst)) { worst = off; said = "got " got ", expected " want " +- " tolerance; at = $0 }
    }
    NR == 1 { next }
    '"$2"'
    END {
      printf "%s: %d values, the worst at %.3g of its tolerance: %s\n", name, judged, worst, said
      if (judged > 0 && worst <= 1) exit 0
      print "  " at
      exit 1
    }' "$3"
}

# judge_rgb(want, tolerance): all three channels of the irradiance of a line, and of a floor that reflects half the
# radiance L = E / (2 pi).
half_grey_floor='
  function judge_rgb(want, tolerance,    c) {
    for (c = 7; c <= 9; c++) judge($c, want, tolerance)
    for (c = 4; c <= 6; c++) judge($c, want / 6.283185307, tolerance / 6.283185307)
  }'
