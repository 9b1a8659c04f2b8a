# In bash, each tool completes the options that its help names and no others, and the words of those that have some; the
# script for zsh has the same options.
cd "$STRAD_SOURCE_DIR"
source tests/pipelines/options_of_help.bash

# What bash offers for the last of the words of a command line.
offered() {
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  compopt() { true; } # bash has it during a completion only
  "_${1//-/_}"
  printf '%s\n' "${COMPREPLY[@]}"
}

for tool in tools/strad-*.cpp; do
  tool=$(basename "$tool" .cpp)
  source <("$tool" --completion bash)
  complete -p "$tool" | grep -q -- "-F _${tool//-/_} "
  help=$(options_of_help "$tool")
  diff <(echo "$help") <(offered "$tool" - | sort)
  diff <(echo "$help") <("$tool" --completion zsh | sed -nE "s/^  '(\*|\([^)]*\))(-[A-Za-z0-9-]*)[=+]?\[.*/\2/p" | sort)
done

[ "$(offered strad-frame --tone '' | tr '\n' ' ')" = 'linear srgb filmic ' ]
[ "$(offered strad-frame --tone f)" = filmic ]
[ "$(offered strad-frame --tone = f)" = filmic ]   # as bash cuts --tone=f
[ -z "$(offered strad-frame --output r)" ]         # the shell's own names of files
[ "$(offered strad-frame room.strad --prev)" = --preview ]

status=0
error=$(strad-info --completion fish 2>&1) || status=$?
[ $status = 2 ]
[ "$error" = "strad-info: --completion: found 'fish', expected bash or zsh" ]
