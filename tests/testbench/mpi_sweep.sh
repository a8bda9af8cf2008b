#!/usr/bin/env bash
# mpi_sweep.sh STEPLOCK DRIVE WORK: the shards of a sweep as two ranks of Open MPI, merged, are the whole.
# A sweep with failed runs exits with 1, which is not the matter here.
set -euo pipefail
export STEPLOCK=$1 DRIVE=$2 WORK=$3
"$(dirname "$0")/../empty_folder" "$WORK"

# The four runs of this seed start: a lost one is simulated for half a minute, and says no more of shards.
sweep() { "$STEPLOCK" sweep "$DRIVE" --runs 4 --seed 3 --rtl 0 "$@" >/dev/null || [ $? -eq 1 ]; }
rank() { sweep --jobs 1 --shard "$OMPI_COMM_WORLD_RANK/$OMPI_COMM_WORLD_SIZE" --out "$WORK/shard$OMPI_COMM_WORLD_RANK"; }
export -f sweep rank

mpirun -n 2 --oversubscribe --allow-run-as-root bash -c rank
"$STEPLOCK" merge "$WORK/shard0" "$WORK/shard1" --out "$WORK/merged" >/dev/null || [ $? -eq 1 ]
sweep --jobs 2 --out "$WORK/whole"
for name in runs.csv sweep.json; do cmp "$WORK/merged/$name" "$WORK/whole/$name"; done
# Neither rank did all the work.
for k in 0 1; do [ "$(wc -l <"$WORK/shard$k/runs.csv")" -lt "$(wc -l <"$WORK/whole/runs.csv")" ]; done
