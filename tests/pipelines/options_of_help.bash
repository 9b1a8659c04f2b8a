# options_of_help TOOL: the options that its help names, sorted. They start a line of the help, or follow a comma there.
options_of_help() {
  "$1" --help | sed -nE 's/^ +(-.*)/\1/p' | sed 's/  .*//' | grep -oE '(^|[ ,])--?[A-Za-z0-9][A-Za-z0-9-]*' |
    tr -d ' ,' | sort -u
}
