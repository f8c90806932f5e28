#!/usr/bin/env bash
# Checks that every source file, script and picture that a comment or a page names is there. A source may be named
# from src/, from tests/ or from its own folder ("world/scene.hpp", "scene.hpp").
set -euo pipefail
cd "$(dirname "$0")/.."
missing=0
# cited FILE... < NAMES: where a name is no file's path or the end of one, says so.
files=$(git ls-files -co --exclude-standard 2>/dev/null || find . -path ./build -prune -o -type f -print)
check() {
    local place name
    while IFS=: read -r place name; do
        grep -qE "(^|/)${name//./\\.}$" <<<"$files" && continue
        echo "$place: cites $name, which does not exist"
        missing=1
    done
}
in_comments() {
    grep -rn '//' src tests bench --include='*.?pp' | sed -E 's|^([^:]+:[0-9]+):.*//|\1 |' | grep -E ' .*\.[hc]pp\b'
}
check < <(in_comments | while read -r place text; do
    grep -oE '[a-z0-9_/]+\.[hc]pp\b' <<<"$text" | sed "s|^|${place/:/ line }:|"
done)
check < <(grep -noE '[a-z0-9_/]+\.[hc]pp\b|\b(docs|assets|scripts|src|tests|bench)/[a-zA-Z0-9_/.-]+\.[a-z]+\b' README.md docs/*.md |
    sed -E 's/^([^:]+):([0-9]+):/\1 line \2:/')
exit "$missing"
