#!/bin/sh
# A sweep or a hunt on all processors of this machine, by GNU parallel:
#   parallel.sh SHARDS flipside sweep pinball --out DIR
# Each shard writes its files into DIR; the last line finds all of them done, and writes what they make together.
set -eu
shards=$1
shift
seq "$shards" | parallel --quote --halt soon,fail=1 "$@" --shard "{}/$shards"
exec "$@"
