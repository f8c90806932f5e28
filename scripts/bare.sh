#!/usr/bin/env bash
# Tries both commands of README.md on a release of Debian, from nothing: scripts/bare.sh bookworm|trixie [--all]
# Makes a bare system by debootstrap, clones HEAD into it, runs ./run.sh and ./test.sh there (with --all: ./test.sh --all)
# and prints exit codes and times. Needs root, debootstrap and 6 GB in ${TMPDIR:-/var/tmp}; mirror and proxy are those of
# this machine's apt. Exit code 0 where both commands had it, else 1.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() { echo "usage: $0 bookworm|trixie [--all]" >&2 && exit 2; }
case "${1:-}" in bookworm | trixie) release=$1 ;; *) usage ;; esac
case "${*:2}" in '') tests='./test.sh' ;; --all) tests='./test.sh --all' ;; *) usage ;; esac
# shellcheck source=scripts/bare_system.sh
source scripts/bare_system.sh

# try COMMAND: runs it in the clone; adds a line to the summary.
summary='' all_good=true
try() {
    local started=$SECONDS code=0
    printf '\n== %s on Debian %s\n' "$1" "$release"
    inside_it "cd /flipside && $1" || code=$?
    ((code == 0)) || all_good=false
    started=$((SECONDS - started))
    summary+=$(printf '%-14s exit code %d, %d min %02d s' "$1" "$code" $((started / 60)) $((started % 60)))$'\n'
}

make_bare_system
git clone --quiet --depth 1 "file://$PWD" "$root/flipside"
try ./run.sh
try "$tests"
printf '\n== Debian %s, %s\n%s' "$release" "$(git rev-parse --short HEAD)" "$summary"
$all_good
