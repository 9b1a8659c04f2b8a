# In bash, each tool completes the options that its help names and no others, and the words of those that have some; the
# script for zsh has the same options.
cd "$STRAD_SOURCE_DIR"

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
  help=$("$tool" --help | sed -nE 's/^ +(-.*)/\1/p' | sed 's/  .*//' | grep -oE '(^|[ ,])--?[A-Za-z0-9][A-Za-z0-9-]*' |
    tr -d ' ,' | sort -u)
  diff <(echo "$help") <(offered "$tool" - | sort)
  diff <(echo "$help") <("$tool" --completion zsh | sed -nE "s/^  '(\*|\([^)]*\))(-[A-Za-z0-9-]*)[=+]?\[.*/\2/p" | sort)
done

[ "$(offered strad-frame --tone '' | tr '\n' ' ')" = 'linear srgb filmic ' ]
[ "$(offered strad-frame --tone f)" = filmic ]
[ "$(offered strad-frame --tone = f)" = filmic ]   # as bash cuts --tone=f
[ -z "$(offered strad-frame --output r)" ]         # the shell's own names of files
[ "$(offered strad-frame room.strad --prev)" = --preview ]

status=0
strad-info --completion fish 2>errors.$$ || status=$?
[ $status = 2 ] && grep -qx "strad-info: --completion: found 'fish', expected bash or zsh" errors.$$ || { cat errors.$$; status=1; }
rm -f errors.$$
[ $status = 2 ]
