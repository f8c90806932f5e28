#!/usr/bin/env bash
# Runs clang-tidy over every C++ file that a finished build compiled: scripts/tidy.sh PRESET
# What passed is remembered, as ccache remembers objects: a file is looked at again when it or any file that it reads
# has changed, or the compile commands, the checks, or clang-tidy.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$PWD/build/$1
passed=${XDG_CACHE_HOME:-$HOME/.cache}/flipside/tidy
mkdir -p "$passed"
find "$passed" -type f -mtime +30 -delete

# Of every object one line: the file that was compiled, and then all that was read for it, with tabs between.
files_read() {
    ninja -C "$build" -t deps | awk '/^    / { file = substr($0, 5); line = line "\t" file }
                                     /^    / && unit == "" && /\.(cpp|cxx)$/ { unit = file }
                                     /^$/ { if (unit != "") print unit line; unit = line = "" }'
}
# check LINE
check() {
    local unit=${1%%$'\t'*} known
    if [[ $unit != /* ]]; then unit=$build/$unit; fi
    # A file that puts others together says nothing that those do not say, but where the build is.
    known=$passed/$({
        echo "$common"
        tr '\t' '\n' <<<"$1" | grep -v '/Unity/' | (cd "$build" && xargs -d '\n' sha256sum) | sed "s|$PWD/||"
    } | sha256sum | cut -c 1-32)
    if [[ ! -e $known ]]; then clang-tidy -p "$build" --quiet "$unit" 2> >(grep -v 'warnings generated' >&2); fi
    touch "$known"
}
common=$({ clang-tidy --version && cat .clang-tidy tests/.clang-tidy && sed "s|$PWD||g" "$build/compile_commands.json"; } |
    sha256sum)
export -f check
export build passed common
files_read | xargs -d '\n' -n 1 -P "$(nproc)" bash -euc 'check "$1"' check
