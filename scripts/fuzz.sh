#!/usr/bin/env bash
# Fuzzes for long: scripts/fuzz.sh HOURS [TARGET]. The time is shared by all targets of tests/fuzz, or given to one.
# scripts/fuzz.sh 30s [TARGET] gives each target that many seconds, from the same seed every time, and stops a target
# at its first finding.
#
# What is found stays outside the tree, in $FLIPSIDE_FUZZ_DIR (default ~/.cache/flipside-fuzz): corpus/TARGET grows
# from run to run, findings/TARGET holds inputs that broke something, log.tsv has a line per run. An interruption
# loses nothing but the figures of the runs under way.
# FLIPSIDE_FUZZ_PRESET=fuzz-fast fuzzes without the sanitizers, several times faster.
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

usage() { echo "usage: $0 HOURS|SECONDSs [TARGET]" >&2 && exit 2; }
[[ ${1:-} =~ ^([0-9]+(\.[0-9]+)?)(s?)$ ]] || usage
(($# <= 2)) || usage
amount=${BASH_REMATCH[1]} seconds_each=${BASH_REMATCH[3]:+yes}
preset=${FLIPSIDE_FUZZ_PRESET:-fuzz}
folder=${FLIPSIDE_FUZZ_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/flipside-fuzz}
mapfile -t targets < <(sed -n 's/^flipside_fuzz_target(\([a-z]*\).*/\1/p' tests/fuzz/CMakeLists.txt)
if [[ ${2:-} ]]; then
    [[ " ${targets[*]} " == *" $2 "* ]] || { echo "$0: no target '$2'; there are ${targets[*]}" >&2 && exit 2; }
    targets=("$2")
fi
jobs=$(nproc)
((jobs > ${#targets[@]})) && jobs=${#targets[@]}
if [[ $seconds_each ]]; then
    slice=${amount%.*} rounds=1 seed=1
else
    slice=$(awk -v h="$amount" -v j="$jobs" -v n="${#targets[@]}" 'BEGIN { s = h * 3600 * j / n; print int(s > 600 ? 600 : s < 1 ? 1 : s) }')
    rounds=$(awk -v h="$amount" -v j="$jobs" -v n="${#targets[@]}" -v s="$slice" 'BEGIN { print int(h * 3600 * j / n / s + 0.5) }')
    seed=0 # another one each time
fi

install_missing "${build_packages[@]}" "${gate_packages[@]}"
build "$preset" "${targets[@]/#/fuzz_}"
mkdir -p "$folder/logs"

# figure NAME LOG: the last value that libFuzzer's log has for it.
figure() { sed -n "s/.*$1:* *\([0-9]\+\).*/\1/p" "$2" | tail -n 1; }

# run TARGET SECONDS: one libFuzzer process until the time is up or something is found. False for a finding.
run() {
    local target=$1 status=0 log inputs
    mkdir -p "$folder/corpus/$target" "$folder/findings/$target"
    log=$folder/logs/$target.$BASHPID.$(date +%s)
    mapfile -t inputs < <(find "tests/fuzz/corpus/$target" "tests/fuzz/regressions/$target" -maxdepth 0 2>/dev/null)
    "build/$preset/tests/fuzz/fuzz_$target" -max_total_time="$2" -seed=$seed -timeout=600 -entropic=0 -mutate_depth=1 -rss_limit_mb=3000 -max_len=8000 \
        -dict=tests/fuzz/json.dict -artifact_prefix="$folder/findings/$target/" -print_final_stats=1 \
        "$folder/corpus/$target" "${inputs[@]}" \
        >"$log" 2>&1 || status=$?
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$(date +%FT%T)" "$preset" "$target" "$(figure stat::number_of_executed_units "$log")" \
        "$(figure cov "$log")" "$(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)" >>"$folder/log.tsv"
    ((status == 0)) && rm -f "$log" && return
    grep -hE 'violation:|^==.*ERROR|runtime error|what\(\)|Test unit written' "$log" | sed "s/^/$target: /"
    return 1
}

# fuzz TARGET: its slice of the time, over again after a finding.
fuzz() {
    local end=$((SECONDS + slice)) ok=true
    while ((SECONDS < end)); do
        run "$1" $((end - SECONDS)) || ok=false
        $ok || [[ ! $seconds_each ]] || break
    done
    $ok
}

all_ok=true
for ((round = 0; round < rounds; ++round)); do
    running=0
    for target in "${targets[@]}"; do
        ((running < jobs)) || { wait -n || all_ok=false; running=$((running - 1)); }
        fuzz "$target" &
        running=$((running + 1))
    done
    for ((; running > 0; --running)); do wait -n || all_ok=false; done
done

awk -F'\t' '{ runs[$3 " " $2] += $4; if ($5 > cov[$3 " " $2]) cov[$3 " " $2] = $5; if ($6) found[$3 " " $2]++ }
    END { for (t in runs) printf "%-24s %12d executions, %6d edges covered, %d findings\n", t, runs[t], cov[t], found[t] }' \
    "$folder/log.tsv" | sort
echo "All of it is in $folder"
$all_ok
