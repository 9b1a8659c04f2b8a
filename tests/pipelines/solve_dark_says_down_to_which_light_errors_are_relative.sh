# A room lit through two doors has a ten thousandth of the light of the first: with --dark 1 errors count alike everywhere,
# so that its links are as coarse as they can be; the usual share asks for more of them, and a smaller one for more again.
cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT

"$STRAD_SOURCE_DIR/scenes/trials/trials.sh" doors doors
strad-import -q doors/doors.obj | strad-motion -q doors/doors.motion >scene.strad
links() {
  strad-solve -q -e 0.05 --at 4 --stats stats.json "$@" -o solved.strad scene.strad
  tr -d '\n' <stats.json | sed 's/.*"total": *{//; s/}.*//; s/.*"links": *\([0-9]*\).*/\1/'
}
alike=$(links --dark 1) usual=$(links) darker=$(links --dark 1e-6)
[ "$alike" -lt "$usual" ]
[ "$usual" -lt "$darker" ]

# What is no share is refused.
for share in 0 -0.1 1.5 nan; do
  status=0
  strad-solve --dark=$share -o none.strad scene.strad 2>err || status=$?
  [ $status = 2 ]
  [ "$(wc -l <err)" = 1 ]
  [ ! -e none.strad ]
done
