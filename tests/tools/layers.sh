#!/usr/bin/env bash
# Who may include whom: the arrows of the house run one way.
#   layers.sh ROOT        fails, and names each include, where a folder includes one that it may not know
set -euo pipefail
cd "$1"
# Of the testbench: what both drives share, and either drive, which does not know the other.
grep -rnE '^#include "(hls|model|generator|testbench|drives|rtl)/' hls model generator testbench/{engine,run,report,drive/six_step,drive/sinusoidal} |
  awk -F'[:"]' '
    BEGIN {  # folder: what it may include, as the beginning of a path
      may["hls/numeric"] = "hls/numeric/"
      may["hls/bridge"] = may["hls/numeric"] " hls/bridge/"
      may["hls/six_step"] = may["hls/bridge"] " hls/six_step/"
      may["hls/sinusoidal"] = may["hls/bridge"] " hls/sinusoidal/"
      may["hls/bus"] = "hls/"
      may["model"] = "model/"
      may["generator"] = "generator/"
      may["testbench/engine"] = "hls/ model/ testbench/engine/"
      may["testbench/run"] = may["testbench/engine"] " testbench/drive_file/ testbench/run/"
      may["testbench/report"] = may["testbench/run"] " testbench/report/"
      may["testbench/drive/six_step"] = may["testbench/report"] " rtl/ports/ testbench/drive/six_step/"
      may["testbench/drive/sinusoidal"] = may["testbench/report"] " rtl/ports/ testbench/drive/sinusoidal/"
    }
    {
      split($1, part, "/")
      folder = part[1] ~ /^(hls|testbench)$/ ? part[1] "/" part[2] : part[1]
      if (folder == "testbench/drive") folder = folder "/" part[3]
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
