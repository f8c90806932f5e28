#!/usr/bin/env bash
# A sweep and a hunt in eight shards under a scheduler give the same bytes as in one go, but for times:
#   same_bytes.sh parallel|slurm PROGRAM
set -euo pipefail
scheduler=$1 program=$2
schedulers=$(cd "$(dirname "$0")/../../examples/schedulers" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
trap 'echo "line $LINENO: $BASH_COMMAND" >&2' ERR
cd "$folder"

# The program, with a list of what was asked of it.
cat > noted <<EOF
#!/bin/sh
printf '%s\n' "\$*" >> '$folder/asked'
exec '$program' "\$@"
EOF
chmod +x noted

in_shards() {
    case $scheduler in
        parallel) "$schedulers/parallel.sh" 8 "$folder/noted" "$@" ;;
        slurm) "$schedulers/one_node.sh" "$schedulers/slurm.sh" 8 "$folder/noted" "$@" ;;
    esac
}
# Eight shards, each once, and the line that puts them together.
check_asked() {
    local number
    for number in 1 2 3 4 5 6 7 8; do
        [[ $(grep -c -- "--shard $number/8\$" asked) == 1 ]] || { cat asked >&2; echo "shard $number was not asked for once" >&2; exit 1; }
    done
    [[ $(grep -vc -- --shard asked) == 1 && $(wc -l < asked) == 9 ]] || { cat asked >&2; exit 1; }
    rm asked
}
# A table without its columns of times, which are measured.
untimed() {
    awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) timed[i] = $i ~ /^cpu_/ }
                      { for (i = 1; i <= NF; ++i) if (timed[i]) $i = ""; print }' "$1"
}

sweep=(sweep toy drop cradle --quick --finest 30 --contenders custom-continuous,box2d)
"$program" "${sweep[@]}" --out one > /dev/null
in_shards "${sweep[@]}" --out 'in eight' > /dev/null
check_asked
diff -r one/windows 'in eight/windows'
diff one/plan.json 'in eight/plan.json'
diff one/blame.csv 'in eight/blame.csv'
diff <(untimed one/sweep.csv) <(untimed 'in eight/sweep.csv')
(($(wc -l < one/sweep.csv) == 7))  # a header, three variants by two contenders

hunt=(hunt --engine box2d --goal overlap --scenes 50 --rounds 8 --length 0.2)
"$program" "${hunt[@]}" --out hunted > /dev/null
in_shards "${hunt[@]}" --out 'hunted in eight' > /dev/null
check_asked
diff -r hunted 'hunted in eight'
[[ -s hunted/worst.json ]]
