#!/usr/bin/env bash
# Installs what is missing, builds Flipside and opens its window on the pinball table. Arguments go to flipside:
#   ./run.sh toy --view overlay
# Where there is no display, and no arguments, both engines play the table, are compared, and a picture is written.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/packages.sh
echo "Flipside: installs missing packages, builds Release in build/release, starts the pinball table."
install_missing "${build_packages[@]}"
build release flipside

flipside=build/release/src/app/flipside
if (($#)); then exec "$flipside" "$@"; fi
if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then exec "$flipside" play pinball; fi

echo "There is no display: both engines play the table for 10 s, and a picture shows where they are then."
"$flipside" compare pinball --engines custom,box2d --seconds 10
mkdir -p out
xvfb-run -a -s '-screen 0 1600x1000x24' "$flipside" render pinball --engine custom --view split --at 1.6 --show tracks \
    --out out/pinball.png
echo "The picture: $PWD/out/pinball.png"
