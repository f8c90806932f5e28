#!/usr/bin/env bash
# Writes the tables of docs/accuracy.md anew from a report's data, and prints the figures that its sentences need:
#   scripts/accuracy_tables.sh REPORT      a folder that `flipside report --out REPORT` has made
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# = 1 ] && [ -f "$1/data/sweep.csv" ] || { echo "usage: $0 REPORT (with data/sweep.csv)" >&2 && exit 2; }
page=docs/accuracy.md new=$(mktemp)
trap 'rm -f "$new"' EXIT

awk -F, -v out="$new" '
function grouped(n, text) {
    text = sprintf("%.0f", n)
    while (match(text, /[0-9][0-9][0-9][0-9]($|,)/)) text = substr(text, 1, RSTART) "," substr(text, RSTART + 1)
    return text
}
# Two digits: 39, 6.4, 0.21, 9.4e-2.
function error(x, text) {
    if (x >= 9.95) return sprintf("%.0f", x)
    if (x >= 0.0995) return sprintf("%.2g", x) + 0
    text = sprintf("%.1e", x)
    sub(/e-0/, "e-", text)
    return text
}
function cost(s) { return s < 0.01 ? grouped(1e6 * s) " µs" : sprintf("%.0f ms", 1e3 * s) }
function row(variant, contender, steps, name,    k) {
    k = variant SUBSEP contender SUBSEP steps
    if (!(k in median)) { print "no " contender " at 1/" steps " on " variant > "/dev/stderr"; failed_row = 1; return }
    printf "| %s | 1/%d | %s | %s | %s | %d, %d of %s%s | %s |\n", name, steps, error(median[k]), error(p95[k]),
        failed[k] ? "failed" : error(largest[k]), missed[k], spurious[k], grouped(impacts[k]),
        failed[k] ? "; " failed[k] " failed" : "", cost(cpu[k]) > out
}
function errors_table(variant) {
    print "| solver | step, s | error: median | 95 % | largest | missed, added impacts | cost of a second |" > out
    print "|---|---|---|---|---|---|---|" > out
    row(variant, "custom-continuous", 30, "custom, continuous")
    row(variant, "custom-continuous", 60, "custom, continuous")
    row(variant, "custom-simple", 60, "custom, simple")
    row(variant, "custom-simple", 7680, "custom, simple")
    row(variant, "custom-simple-tuned", 60, "custom, simple, 16 motion iterations")
    row(variant, "box2d", 60, "Box2D")
    row(variant, "box2d", 7680, "Box2D")
    row(variant, "box2d-no-bullets", 60, "Box2D, no bullets")
    row(variant, "box2d-substeps-4", 60, "Box2D, 4 sub-steps")
    row(variant, "box2d-tuned", 7680, "Box2D, tuned")
    row(variant, "reference-53", 60, "reference, double")
}
# The cheapest setting of an engine whose median error is surely below the limit, and its cost.
function cheapest(variant, engine, limit,    k, best, part) {
    best = ""
    for (k in median) {
        split(k, part, SUBSEP)
        if (part[1] != variant || engine_of[k] != engine || !(high[k] < limit)) continue
        if (best == "" || cpu[k] < cpu[best]) best = k
    }
    if (best == "") return "nothing surely | "
    split(best, part, SUBSEP)
    return name_of[part[2]] " at 1/" part[3] " s | " cost(cpu[best])
}
function advice_table(    l, v) {
    print "| below, radii | scene | take of ours | cost of a second | of Box2D | cost of a second |" > out
    print "|---|---|---|---|---|---|" > out
    for (l = 1; l <= 4; ++l)
        for (v = 1; v <= 4; ++v)
            printf "| %s | %s | %s | %s |\n", limits[l], scenes[v], cheapest(variants[v], "custom", limits[l] + 0),
                cheapest(variants[v], "box2d", limits[l] + 0) > out
}
# Mean factor by which the median falls for each halving of the step, from one to the other.
function falls(variant, from, to) {
    return exp(log(median[variant, "box2d", from] / median[variant, "box2d", to]) / (log(to / from) / log(2)))
}
function sentences(    v, name, k, part, best, steps, base) {
    for (v = 1; v <= 4; ++v) {
        name = variants[v]; base = name SUBSEP "custom-continuous" SUBSEP 60; best = ""
        for (steps in finer) {
            k = name SUBSEP "box2d" SUBSEP steps
            if (best == "" || median[k] < median[best]) best = k
        }
        split(best, part, SUBSEP)
        k = name SUBSEP "box2d" SUBSEP 60
        printf "%s: median of Box2D / ours %.2g; Box2D is best at 1/%s (%d windows), %.0f times the cost; ", name,
            median[k] / median[base], part[3], windows[best], cpu[best] / cpu[base]
        printf "halving the step, error / %.2f to 1/960, / %.2f below; ", falls(name, 30, 960), falls(name, 960, 7680)
        printf "misses %.0f %%, adds %.0f %%; reference / ours %.2f\n", 100 * missed[k] / impacts[k],
            100 * spurious[k] / impacts[k], cpu[name, "reference-53", 60] / cpu[base]
    }
    inexact = ""
    for (k in exact) if (k ~ "custom-continuous" && exact[k] != windows[k]) inexact = inexact " " k
    print "continuous: windows that are not exact:" (inexact == "" ? " none" : inexact)
}
BEGIN {
    split("pinball-1 pinball-8 toy rain", variants, " ")
    split("`pinball`, 1 ball;`pinball`, 8 balls;`toy`;`rain`, 320 balls, in flight", scenes, ";")
    split("1 0.1 0.01 1e-9", limits, " ")
    split("custom-continuous=continuous;custom-simple=simple;custom-simple-tuned=simple, 16 motion iterations;" \
          "box2d=as it comes;box2d-no-bullets=no bullets;box2d-20-10=more iterations;box2d-substeps-4=4 sub-steps;" \
          "box2d-verlet=exact parabolas;box2d-fine-arcs=fine arcs;box2d-tuned=tuned", named, ";")
    for (n in named) { split(named[n], pair, "="); name_of[pair[1]] = pair[2] }
    scene["**`pinball`, 1 ball**"] = "pinball-1"; scene["**`pinball`, 8 balls**"] = "pinball-8"
    scene["**`toy`**"] = "toy"; scene["**`rain`, 320 balls, in its first 1.5 s**"] = "rain"
}
FNR == NR {
    if (FNR == 1) { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    steps = sprintf("%.0f", 1 / $column["dt"])
    k = $column["variant"] SUBSEP $column["contender"] SUBSEP steps
    engine_of[k] = $column["engine"]; windows[k] = $column["windows"]; failed[k] = $column["failed"] + 0
    median[k] = $column["median"] + 0; high[k] = $column["median_high"] == "" ? 1e300 : $column["median_high"] + 0
    p95[k] = $column["p95"] + 0; largest[k] = $column["max"] + 0; exact[k] = $column["exact"]
    impacts[k] = $column["impacts"]; missed[k] = $column["missed"]; spurious[k] = $column["spurious"]
    cpu[k] = $column["cpu_min"] + 0
    if ($column["contender"] == "box2d") finer[steps] = 1
    next
}
/^\|/ && in_table { next }
{ in_table = 0 }
$0 in scene { variant = scene[$0] }
/^\| solver / { errors_table(variant); in_table = 1; next }
/^\| below, radii / { advice_table(); in_table = 1; next }
{ print > out }
END {
    if (failed_row) exit 1
    sentences()
}
' "$1/data/sweep.csv" "$page"
cp "$new" "$page"
