#!/usr/bin/env bash
# Who may include whom: the arrows of the house run one way.
#   layers.sh ROOT        fails, and names each include, where a folder includes one that it may not know
set -euo pipefail
cd "$1"
grep -rnE '^#include "(hls|model|generator|testbench|drives)/' hls model generator |
  awk -F'[:"]' '
    BEGIN {  # folder: what it may include, as the beginning of a path
      may["hls/numeric"] = "hls/numeric/"
      may["hls/bridge"] = may["hls/numeric"] " hls/bridge/"
      may["hls/six_step"] = may["hls/bridge"] " hls/six_step/"
      may["hls/sinusoidal"] = may["hls/bridge"] " hls/sinusoidal/"
      may["hls/bus"] = "hls/"
      may["model"] = "model/"
      may["generator"] = "generator/"
    }
    {
      split($1, part, "/")
      folder = part[1] == "hls" ? "hls/" part[2] : part[1]
      ++seen
      if (!(folder in may)) { printf "%s:%s: %s is no folder of the house\n", $1, $2, folder; bad = 1; next }
      n = split(may[folder], known, " ")
      for (i = 1; i <= n; ++i) if (index($4, known[i]) == 1) next
      printf "%s:%s: %s may not know %s, only %s\n", $1, $2, folder, $4, may[folder]
      bad = 1
    }
    END {
      if (!seen) print "layers.sh: there is no include"
      exit bad || !seen
    }'
