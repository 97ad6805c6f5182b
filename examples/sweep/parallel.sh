#!/usr/bin/env bash
# parallel.sh PLAN.json DIR SHARDS [OPTIONS OF GNU PARALLEL]: a shard of the sweep in each job of GNU Parallel, on this
# machine or, with --sshloginfile HOSTS --workdir ., on several that share the folder. Then makes the tables. Run it again
# after a failure: what is done is not done twice. $GLINT names the program, if it is not glint in PATH.
set -euo pipefail

usage="usage: parallel.sh PLAN.json DIR SHARDS [OPTIONS OF GNU PARALLEL]"
plan=${1:?$usage} folder=${2:?$usage} shards=${3:?$usage}
shift 3
glint=${GLINT:-glint}
seq 0 $((shards - 1)) |
    parallel --will-cite "$@" "$glint" sweep "$plan" --shard "{}/$shards" --out "$folder"
exec "$glint" sweep --merge "$folder"
