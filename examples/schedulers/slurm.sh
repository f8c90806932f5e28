#!/bin/sh
# A sweep or a hunt as a job array of Slurm, in a folder that all nodes share:
#   slurm.sh SHARDS flipside sweep pinball --out DIR
# Each task of the array does one shard and writes its files into DIR. When all have ended the last line finds them
# done, and writes what they make together. Limits of time and memory are the cluster's: SBATCH_TIMELIMIT,
# SBATCH_MEM_PER_CPU.
set -eu
shards=$1
shift
sbatch --wait --quiet --array="1-$shards" --cpus-per-task=1 --output=/dev/null "$(dirname "$0")/one_shard.sh" "$@"
exec "$@"
