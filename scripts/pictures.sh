#!/usr/bin/env bash
# Remakes the pictures of README.md in docs/ from the Release build, four by `flipside render`, one by the window
# itself and one by `flipside report`. Needs no display.
set -euo pipefail
cd "$(dirname "$0")/.."
if [[ -z ${IN_XVFB:-} ]]; then
    IN_XVFB=1 exec xvfb-run -a -s '-screen 0 1440x900x24' "$0"
fi
flipside=build/release/src/app/flipside
render() { "$flipside" render "$@" --engine custom --width 1280 --height 800; }

mkdir -p docs
render pinball --view split --at 1.6 --show tracks --out docs/split.png
render pinball --view overlay --at 1.6 --show tracks --out docs/overlay.png
"$flipside" render pinball --engine reference --view overlay --at 1.45 --width 1280 --height 800 --show tracks \
    --out docs/reference.png
render toy --view split --at 4 --show boxes,cells,velocity --out docs/insides.png

folder=$(mktemp -d)
"$flipside" play pinball --script assets/scenes/pinball.script.json --view split --width 1440 --height 900 \
    --screenshots "$folder" &
window=$(xdotool search --sync --name '^Flipside$' | tail -n 1)
xdotool windowmove "$window" 0 0 windowfocus --sync "$window"
sleep 2
xdotool key F12
sleep 1
xdotool key Escape
wait
mv "$folder"/*.png docs/panel.png

"$flipside" report --quick --out "$folder" >/dev/null
cp "$folder/figures/work-pinball-1.png" docs/report.png
rm -r "$folder"
