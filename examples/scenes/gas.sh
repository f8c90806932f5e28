#!/bin/sh
# A gas, as a scene file: N elastic balls in a box, a fifth of which they cover, without gravity. It is the gas
# of flipside_bench (src/lab/scenes/elastic_scenes.hpp).
#
#     examples/scenes/gas.sh 1000 > gas.json
set -eu
usage() {
    echo "usage: $0 N    (a number of balls, from 1 to 1000000)" >&2
    exit 2
}
case ${1:-} in
    '' | *[!0-9]* | 0* | ????????*) usage ;;
esac
[ "$1" -le 1000000 ] || usage  # more is no scene
awk -v n="$1" 'BEGIN {
    radius = 0.1; pi = atan2(0, -1)
    side = sqrt(n * pi * radius * radius / 0.2)
    columns = int(sqrt(n)); if (columns * columns < n) ++columns
    printf "{\"format\": \"flipside-scene/1\", \"name\": \"gas\", \"about\": \"A gas of %d elastic balls.\",\n", n
    printf " \"gravity\": [0, 0], \"rest_speed\": 0, \"materials\": {\"elastic\": {\"restitution\": 1}},\n"
    printf " \"bounds\": {\"min\": [-1, -1], \"max\": [%.17g, %.17g]},\n", side + 1, side + 1
    printf " \"parts\": [{\"name\": \"walls\", \"material\": \"elastic\", \"shape\": {\"type\": \"polyline\", \"closed\": true,\n"
    printf "  \"points\": [[0, 0], [%.17g, 0], [%.17g, %.17g], [0, %.17g]]}}],\n \"balls\": [", side, side, side, side
    for (i = 0; i < n; ++i) {
        speed = 0.5 + (i * 7 % 10) / 10
        printf "%s\n  {\"position\": [%.17g, %.17g], \"velocity\": [%.17g, %.17g], \"radius\": %.17g, \"mass\": 1, \"material\": \"elastic\"}",
            (i ? "," : ""), side / columns * (i % columns + 0.5), side / columns * (int(i / columns) + 0.5),
            speed * cos(2.4 * i), speed * sin(2.4 * i), radius
    }
    printf "\n ]}\n"
}'
