# strad-check finds no error where the solution is exact, and the error of a coarse one: --limit passes and fails.
scenes=$STRAD_SOURCE_DIR/scenes
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

solve() { # solve SCENE OPTIONS
  local scene=$scenes/$1/$1
  shift
  strad-import $scene.obj | strad-motion $scene.motion | strad-solve "$@"
}
status_of() { # status_of COMMAND: prints its exit status
  local status=0
  "$@" >report 2>errors || status=$?
  echo $status
}

# Le = 1, rho = 0.5 in a closed box: reflected radiance L - Le = Le rho / (1 - rho) = 1 everywhere. The deviation of the
# mean of half a million paths is below 0.002, and the solve holds 1 % (tests/analytic/furnace_*).
solve furnace >furnace.strad
for direct in pixel mesh; do
  strad-check --limit 0.01 --direct $direct --points 500 --paths 1024 furnace.strad >report
  awk '
    NR == 1 { found = $1 == "error"; if (!($7 <= 1)) bad = 1 }
    NR == 2 { if (!($2 > -1 && $2 < 1 && $7 <= $2 && $2 <= $9)) bad = 1 }
    $1 == "mean" { if (!($2 > 0.99 && $2 < 1.01)) bad = 1 }
    END { exit !found || bad }' report || { cat report; exit 1; }
done

# A mesh solved to half of the mean radiance is off by far more than 3 %, a finer one by less.
solve lamp -e 0.5 --time 7:8 >coarse.strad
solve lamp -e 0.02 --time 7:8 >fine.strad
check() { strad-check --direct mesh --points 300 --paths 512 "$@"; }
[ "$(status_of check --limit 0.06 coarse.strad)" = 1 ] || { cat report errors; exit 1; }
grep -q '^error' report
[ "$(status_of check --limit 0.06 fine.strad)" = 0 ] || { cat report errors; exit 1; }
[ "$(status_of check coarse.strad)" = 0 ]
