#!/usr/bin/env bash
# Completes by a real bash, with and without a terminal: bash_completion.sh PROGRAM
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$program" completion bash > script.bash
mkdir bin 'some folder'
ln -s "$program" bin/flipside
touch 'a table.json'
PATH=$folder/bin:$PATH
source ./script.bash
compopt() { :; }  # it works only while bash completes

failed=0
# completes WORD... -- REPLY...: the last word is completed by these, in this order.
completes() {
    COMP_WORDS=(flipside)
    while [[ $1 != -- ]]; do COMP_WORDS+=("$1") && shift; done
    shift
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMPREPLY=()
    set +e  # as in a shell of somebody's
    _flipside flipside
    set -e
    [[ "${COMPREPLY[*]}" == "$*" ]] && return
    echo "${COMP_WORDS[*]}: completed by '${COMPREPLY[*]}', not '$*'" >&2
    failed=1
}
completes ru -- run
completes comp -- compare completion
completes pinb -- pinball
completes --vers -- --version
completes --vie -- --view
completes run --eng -- --engine
completes run pinb -- pinball
completes run --engine ref -- reference
completes run --engine = ref -- reference
completes play --view s -- single split
completes render toy --view s -- single split
completes compare --engines b -- box2d
completes compare --engines custom,b -- custom,box2d
completes run toy --engine custom --set solv -- solver=
completes run toy --engine box2d --set solv --
completes run toy --engine custom --set solver = -- continuous simple
completes run toy --engine custom --set solver = s -- simple
completes compare toy --set custom.solv -- custom.solver=
completes compare toy --set custom.solver = s -- simple
completes lessons 04 -- 04-quadtree
completes play --lesson 04 -- 04-quadtree
completes cases galp -- galperin
completes check 'a t' -- 'a table.json'
completes sweep --out some -- 'some folder'
completes run toy --seconds a --
completes run --vie --
((failed == 0))

# As somebody types it, with the key Tab.
cat > keys <<'K'
source ./script.bash; PATH=./bin:$PATH
flipside ru	pinb	--engine cus	--set solv	con	--seconds 0.1 --script none --stats typed.json
exit
K
timeout 60 script -qec 'bash --norc --noprofile -i' /dev/null < keys > terminal 2>&1 || { cat terminal >&2 && exit 1; }
grep -q '"steps": *6' typed.json || { cat terminal >&2 && exit 1; }
