#!/usr/bin/env bash
# Remakes the pictures of README.md and docs/window.md from the Release build, four by `flipside render` and two by the
# window itself; and docs/lessons, a picture of every lesson as the window shows it and an
# index of them, and docs/engine, the figures of docs/engine.md: the tables of some lessons without the lesson.
# `scripts/pictures.sh lessons` makes the pictures of lessons alone, `scripts/pictures.sh lessons 05` one of them,
# `scripts/pictures.sh engine` the figures alone, `scripts/pictures.sh readme` those of README.md. Needs no display.
set -euo pipefail
cd "$(dirname "$0")/.."
if [[ -z ${IN_XVFB:-} ]]; then
    IN_XVFB=1 exec xvfb-run -a -s '-screen 0 1440x900x24' "$0" "$@"
fi
flipside=build/release/src/app/flipside
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

render() { "$flipside" render "$@" --engine custom --width 1280 --height 800; }

# Time and stage on show, as the window reported them last.
on_show() { tail -n 2 "$folder/report" | head -n 1 | grep -oE '"(time|stage)":[0-9.e+-]+' || true; }

# photograph PNG KEYS ARGUMENTS...: the window after these keys, once it stands still. $leave leads to where Escape
# closes the window.
photograph() {
    local picture=$1 keys=$2 window before=''
    shift 2
    "$flipside" play --no-settings --scale 1 --report "$folder/report" --screenshots "$folder" "$@" &
    window=$(xdotool search --sync --name '^Flipside$' | tail -n 1)
    xdotool windowmove "$window" 0 0 windowfocus --sync "$window" mousemove 0 0
    # shellcheck disable=SC2086  # they are words
    xdotool key --delay 20 $keys
    until [[ -n $before && $before == "$(on_show)" ]]; do
        before=$(on_show)
        sleep 1
    done
    xdotool key F12
    until [[ -s $folder/flipside-1.png ]]; do sleep 0.1; done
    # shellcheck disable=SC2086  # none or one
    xdotool key ${leave:-} Escape
    wait
    mv "$folder/flipside-1.png" "$picture"
}

# Keys: a step each where the step bar is closed, a stage where it is open.
steps() { printf 'period %.0s' $(seq "$1"); }
whole_steps() { printf 'shift+period %.0s' $(seq "$1"); }
# From the beginning on, wherever it is by now.
from_start() { echo "period r $(steps "$1")"; }
# A ball more every eight steps.
launches() { for ((i = 0; i < $1; ++i)); do echo "space $(steps 8)"; done; }

# When a lesson shows its idea best.
lesson_keys() {
    case $1 in
        01) steps 3 ;;
        02) echo "$(from_start 20) $(launches 20) $(steps 400)" ;;
        03 | 04) from_start 60 ;;
        05) from_start 240 ;;
        06) echo "$(whole_steps 5) $(steps 3)" ;;
        07) steps 3 ;;
        08 | 09) from_start 2 ;;
        10) steps 4 ;;
        11) from_start 57 ;;
        12) from_start 720 ;;
        13) from_start 60 ;;
        14) from_start 120 ;;
        15) from_start 300 ;;
        16) from_start 16 ;;
        17) steps 1 ;;
        18) echo "$(whole_steps 13) $(steps 2)" ;;
        19) from_start 240 ;;
        20) from_start 24 ;;
    esac
}

lessons() {
    mkdir -p docs/lessons
    rm -f "docs/lessons/${1:-}"*.png
    {
        printf '# The lessons\n\nEach as the window shows it; `flipside lessons 8` opens one, `flipside lessons --check`\n'
        printf 'verifies what they claim. Made by `scripts/pictures.sh lessons`.\n'
        "$flipside" lessons | while read -r name words; do
            printf '\n## %s %s\n\n%s\n\n![%s](%s.png)\n' "${name%%-*}" "${words%%: *}" "${words#*: }" "${words%%: *}" "$name"
        done
    } >docs/lessons/README.md
    for lesson in "assets/lessons/${1:-}"*.json; do
        name=$(basename "$lesson" .json)
        photograph "docs/lessons/$name.png" "$(lesson_keys "${name%%-*}")" --lesson "$lesson" --width 1120 --height 700
    done
}

# figure PNG LESSON HEIGHT [KEYS]: the table of a lesson when it shows its idea best, or after other keys.
figure() {
    photograph "docs/engine/$1.png" "F2 ${4:-$(lesson_keys "$2")}" --lesson "${2#0}" --width 840 --height "$3"
}

engine() {
    mkdir -p docs/engine
    figure quadtree 04 620
    figure closest-point 06 560
    figure response 10 560
    figure tunnelling 08 560
    figure time-of-impact 17 560
    figure events 18 600
    figure stack 14 520
    figure sleep 15 620
}

readme() {
    render pinball --view split --at 1.6 --show tracks --out docs/split.png
    render pinball --view overlay --at 1.6 --show tracks --out docs/overlay.png
    "$flipside" render pinball --engine reference --view overlay --at 1.45 --width 1280 --height 800 --show tracks \
        --out docs/reference.png
    render toy --view split --at 4 --show boxes,cells,velocity --out docs/insides.png
    # The last part but two is the left flipper.
    leave=F4 photograph docs/draw.png "F4 shift+Tab shift+Tab shift+Tab" pinball --width 1280 --height 800

    "$flipside" play pinball --no-settings --scale 1 --script assets/scenes/pinball.script.json --view split \
        --width 1440 --height 900 --screenshots "$folder" &
    window=$(xdotool search --sync --name '^Flipside$' | tail -n 1)
    xdotool windowmove "$window" 0 0 windowfocus --sync "$window"
    sleep 2
    xdotool key F12
    sleep 1
    xdotool key Escape Escape  # a game is under way, so the first one asks
    wait
    mv "$folder"/*.png docs/panel.png
}

case ${1:-all} in
    lessons) lessons "${2:-}" ;;
    engine) engine ;;
    readme) readme ;;
    *)
        lessons
        engine
        readme
        ;;
esac
