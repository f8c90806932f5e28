#!/usr/bin/env bash
# libm_calls.sh NM SRC ARCHIVE...: fails where an engine calls an elementary function of the C library, whose last bits
# differ between processors and releases; world/math.hpp has those with the same bits everywhere. Archives show calls
# from templates and headers of other libraries too; the sources show those that the compiler has folded.
set -euo pipefail
nm=$1 src=$2
shift 2
functions='a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erfc?|[lt]gamma'
found=false
calls=$("$nm" --print-file-name --undefined-only "$@" | grep -E " U (__)?($functions)(f|l|f128)?(_finite)?(@.*)?$" || true)
if [[ -n $calls ]]; then
    echo "calls of the C library's:" && echo "$calls"
    found=true
fi
names=$(cd "$src" && {
    grep -rnE "\bstd::($functions)[fl]?\b" world custom reference box2d
    grep -rnE "\bstd::(sin|cos|tan|atan2)[fl]?\b" lab  # they make scenes
} || true)
if [[ -n $names ]]; then
    echo "use flipside::math instead of:" && echo "$names"
    found=true
fi
! $found
