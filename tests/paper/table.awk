# One table of the paper as HTML, the paper's figures beside strad's: those of paper.tsv, then the same columns of strad.
# `table` is its number, `frames` those of strad's animation, `caption` what stands below. A dash: not measured.
BEGIN { FS = "\t" }
/^#/ { next }
$1 == table { for (i = 3; i <= 7; ++i) cell[FILENAME ~ /paper.tsv$/, $2, i] = $i }

function get(who, row, column) { return (who, row, column) in cell ? cell[who, row, column] : "-" }

# A ratio of two numbers, either of which may be missing.
function over(a, b) { return a == "-" || b == "-" || b == 0 ? "-" : a / b }

function number(x, digits) { return x == "-" ? "&#8211;" : sprintf("%." digits "f", x) }

function text(x) { return x == "-" ? "&#8211;" : x }

# All frames alone take as many times as long as one: 600 in the paper, `frames` here.
function acceleration(who, row) {
  return row == "frame" ? "-" : over((who ? 600 : frames) * get(who, "frame", 5), get(who, row, 5))
}

function row(name, key,    who, i, line) {
  line = "<tr><th>" name "</th>"
  for (who = 1; who >= 0; --who) {
    for (i = 3; i <= 7; ++i) line = line "<td>" text(get(who, key, i)) "</td>"
    line = line "<td>" number(acceleration(who, key), 1) "</td>"
  }
  print line "</tr>"
}

function ratio(name, a, b, column,    who, line) {
  line = "<tr><th>" name "</th>"
  for (who = 1; who >= 0; --who) line = line "<td>" number(over(get(who, a, column), get(who, b, column)), 2) "</td>"
  print line "</tr>"
}

END {
  heads = "<th>direct, s</th><th>indirect, s</th><th>total, s</th><th>per frame, s</th><th>memory, MB</th><th>acceleration</th>"
  print "<div class=\"table\" id=\"table-" table "\">\n<table>"
  print "<tr><th></th><th colspan=\"6\">the paper, 2001</th><th colspan=\"6\">strad</th></tr>"
  print "<tr><th></th>" heads heads "</tr>"
  row("constant (Haar, M1)", "m1")
  row("M2", "m2")
  row("M3, strad's default", "m3")
  row("1 frame alone", "frame")
  print "</table>"
  print "<table>\n<tr><th>ratios, which can be compared</th><th>the paper</th><th>strad</th></tr>"
  ratio("M2 to constant, CPU seconds", "m2", "m1", 5)
  ratio("M2 to constant, memory", "m2", "m1", 7)
  ratio("M2, all frames, to 1 frame alone, memory", "m2", "frame", 7)
  ratio("M2, all frames, to 1 frame alone, CPU seconds", "m2", "frame", 5)
  print "</table>\n<p class=\"caption\"><b>Table " table ".</b> " caption "</p>\n</div>"
}
