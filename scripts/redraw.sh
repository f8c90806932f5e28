#!/bin/sh
# Draws the figures of a report again, as SVG and PNG, from the points that lie beside them: needs gnuplot alone.
#   scripts/redraw.sh [REPORT]        default: docs/report
set -eu
cd "${1:-"$(dirname "$0")/../docs/report"}/figures"
for script in *.gp; do
    gnuplot -d "$script"
done
