#!/usr/bin/env bash
# Prints the manual page of the program, in the language of man: the help of the program and of each
# subcommand. help2man would take the subcommands for options and leave out theirs.
#
#   manual_page.sh PROGRAM
set -euo pipefail
program=$1

# Converts the help of the program or of a subcommand.
convert() {
  awk '
    # man takes these characters for commands or for typographic ones.
    function text(line) { gsub(/\\/, "\\e", line); gsub(/-/, "\\-", line); gsub(/^[.\x27]/, "\\\\\\&&", line); return line }
    # Long lists of values break after commas. An option that is not followed by two blanks has its text on the next line.
    function option(line,   gap, name) {
      gap = match(line, /  +/)
      name = text(gap ? substr(line, 1, gap - 1) : line)
      gsub(/,/, ",\\:", name)
      print ".TP\n.B " name
      if (gap) print text(substr(line, gap + RLENGTH))
    }
    /^Usage: / { print ".PP\n.B " text(substr($0, 8)); next }
    /^[A-Z][A-Za-z ]*:$/ { print ".SS " text(substr($0, 1, length($0) - 1)); next }
    /^  [^ ]/ { option(substr($0, 3)); next }
    /^ +[^ ]/ { sub(/^ +/, ""); print text($0); next }
    /^$/ { print ".PP"; next }
    { print text($0) }'
}

version=$("$program" --version)
name=$("$program" --help | sed -n "1{s/^./\l&/;s/[.]$//;p}")
cat <<END
.TH CROSSFIELD 1 "" "crossfield $version" "User Commands"
.ad l
.nh
.SH NAME
crossfield \\- $name
.SH SYNOPSIS
.B crossfield
.I SUBCOMMAND DOMAIN
.RI [ OPTIONS ]
.SH DESCRIPTION
END
"$program" --help | convert
"$program" --help | sed '1,/^Subcommands:/d' | awk '/^  [a-z]/ { print $1 }' | while read -r subcommand; do
  echo ".SH CROSSFIELD ${subcommand^^}"
  "$program" "$subcommand" --help </dev/null | convert
done
cat <<END
.SH SEE ALSO
The pages of the documentation in /usr/share/doc/crossfield/docs.
END
