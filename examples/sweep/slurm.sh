#!/usr/bin/env bash
# sbatch --array=0-99 slurm.sh PLAN.json DIR [SHARDS]: a shard of the sweep in each task of the array. A task that ends
# with its node is queued again and goes on where it was; a task that failed runs again with `--array=17 ... 100`, where
# SHARDS says how many there are in all. $GLINT names the program, if it is not glint in PATH.
#SBATCH --job-name=glint-sweep
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=glint-sweep.%A.%a.log
#SBATCH --ntasks=1
##SBATCH --gres=gpu:1
##SBATCH --time=04:00:00
set -euo pipefail

plan=${1:?usage: sbatch --array=0-99 slurm.sh PLAN.json DIR [SHARDS]} folder=${2:?the folder of the results is missing}
shards=${3:-$SLURM_ARRAY_TASK_COUNT}
exec "${GLINT:-glint}" sweep "$plan" --shard "$SLURM_ARRAY_TASK_ID/$shards" --out "$folder"
