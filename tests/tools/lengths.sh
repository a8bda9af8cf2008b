#!/usr/bin/env bash
# Lines and files that a reader cannot take in at once: lengths.sh FILE...
#   a line of more than 140 columns; but a message of 60 or more stays in one piece, so that it is found by searching
#   a file of more than 350 lines
# Exit code: 0 none, 1 each is named.
set -euo pipefail
awk '
  function message(line) {  # has one
    while (match(line, /"[^"]*"/)) {
      if (RLENGTH >= 62) return 1
      line = substr(line, RSTART + RLENGTH)
    }
    return 0
  }
  FNR == 1 { if (lines > 350) { print file ": " lines " lines, at most 350: look for the seam"; bad = 1 } file = FILENAME }
  { lines = FNR }
  length($0) > 140 && !message($0) { print FILENAME ":" FNR ": " length($0) " columns, at most 140"; bad = 1 }
  END { if (lines > 350) { print file ": " lines " lines, at most 350: look for the seam"; bad = 1 } exit bad }' "$@"
