#!/bin/sh
# What each task of slurm.sh does.
exec "$@" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT"
