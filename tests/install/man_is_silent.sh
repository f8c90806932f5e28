#!/usr/bin/env bash
# Formats a page; anything that man or groff warns of is an error: man_is_silent.sh MAN PAGE
set -euo pipefail
warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 "$1" --warnings -E UTF-8 -l -Tutf8 -Z "$2" 2>&1 > /dev/null)
[[ -z $warnings ]] || { echo "$warnings" >&2 && exit 1; }
