#!/usr/bin/env bash
# Runs the tests of world, custom and reference under valgrind's memcheck: scripts/valgrind.sh [--quick]
# It finds every use of a value that was never written, also in memory that is allocated, where the address sanitizer
# sees nothing wrong. --quick leaves out the longest tests and takes about 2 minutes on two hardware threads. Tests may
# fail for their limits of time here (the plain run judges them): exit code 1 is for what memcheck found and for crashes.
set -euo pipefail
cd "$(dirname "$0")/.."
source scripts/packages.sh
case "${*:-}" in
    '') left_out='' examples=20 ;;
    --quick) left_out='Allocations.*:Reference.BowlIsAPendulum*:ReferenceWorld.SlidesOverTheJoints*:Crowding.OfAMillionBoxes*:MovingParts.Press*'
        left_out+=':Walls.*:Squeezed.*:Piles.ARowWithoutRoom*'
        left_out+=':ReferenceGates.AreSolidToWhatSlidesRoundTheirEnd:ReferenceWorld.AStepWithTooManySearchesIsRefused'
        left_out+=':ReferenceSmoothJoint.IsAStraightLineAtEveryStep:BroadPhase.AThousandBallsAtOnePoint'
        left_out+=':Math.SineAndCosine:Math.ArcTangent:Math.Expm1:Math.Log1p:Math.Root' examples=2 ;;
    *) echo "usage: $0 [--quick]" >&2 && exit 2 ;;
esac
install_missing "${build_packages[@]}" "${gate_packages[@]}"
build ci test_world test_custom test_reference

logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
# run_shard PROGRAM SHARD: its log is named after its exit code.
run_shard() {
    local log=$logs/$1-$2 code=0
    GTEST_SHARD_INDEX=$2 RC_PARAMS="max_success=$examples" valgrind -q --error-exitcode=9 \
        "build/ci/tests/$1/test_$1" --gtest_filter="-$left_out" >"$log" 2>&1 || code=$?
    mv "$log" "$log.$code"
}
export -f run_shard
export logs left_out examples GTEST_TOTAL_SHARDS=6
for program in custom reference world; do
    for ((shard = 0; shard < GTEST_TOTAL_SHARDS; ++shard)); do echo "$program" "$shard"; done
done | xargs -L 1 -P "$(nproc)" bash -c 'run_shard "$@"' run_shard

shopt -s nullglob
failed=0
for log in "$logs"/*; do
    case ${log##*.} in 0 | 1) continue ;; esac
    ((++failed))
    tail -n 60 "$log"
done
printf '%d tests of world, custom and reference under valgrind: ' "$(cat "$logs"/* | grep -c '^\[ RUN')"
if ((failed)); then echo "errors in $failed of $((3 * GTEST_TOTAL_SHARDS)) parts (above)" && exit 1; fi
echo "no error"
