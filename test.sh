#!/usr/bin/env bash
# Installs what is missing, builds Release and runs every test. With --all, as on every change, then also the gates:
# formatting, the hard cases in full, the same bits from gcc and clang, optimised and not, and for aarch64 (emulated),
# clang-tidy, every test again under the address and undefined-behaviour sanitizers, fuzzing, and the tests of the engines
# under valgrind.
set -euo pipefail
cd "$(dirname "$0")"
source scripts/packages.sh
case "${*:-}" in
    '') gates=false what="builds Release, runs every test" ;;
    --all) gates=true what="builds Release, runs every test, then format, hard cases, golden bits, clang-tidy, the sanitizers and valgrind" ;;
    *) echo "usage: $0 [--all]" >&2 && exit 2 ;;
esac
jobs=$(nproc)
tests_at_once=$((jobs + 1))  # some wait for the disk or for a window
release=release
if $gates; then release=ci; fi  # the same, and warnings are errors
started=$SECONDS
stage() { printf '\n== %s (%d min %02d s)\n' "$1" $(((SECONDS - started) / 60)) $(((SECONDS - started) % 60)); }

echo "Flipside: installs missing packages, $what."
install_missing "${build_packages[@]}" "${test_packages[@]}"
if $gates; then
    install_missing "${gate_packages[@]}"
    stage "clang-format"
    find src tests include examples tools -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' | xargs clang-format --dry-run --Werror
fi
stage "Release build"
build "$release"
stage "tests"
ctest --preset "$release" -j "$tests_at_once"
if $gates; then
    stage "hard cases in full: ours"
    "build/$release/src/app/flipside" cases --engine custom | tail -n 1
    # clang with the checks of the sanitizers: the golden test is among those under the sanitizers
    for preset in debug clang aarch64; do
        stage "same bits: $preset"
        build "$preset" test_golden
        ctest --test-dir "build/$preset" -L golden -j "$jobs" --output-on-failure
    done
    stage "sanitizer build"
    build sanitize
    stage "clang-tidy"
    scripts/tidy.sh sanitize
    stage "tests under the sanitizers"
    ctest --preset sanitize -j "$tests_at_once"
    stage "fuzzing, 20 s per target"
    FLIPSIDE_FUZZ_PRESET=sanitize FLIPSIDE_FUZZ_DIR=build/fuzzed scripts/fuzz.sh 20s
    stage "uninitialised reads: valgrind"
    scripts/valgrind.sh --quick
    stage "all is well"
fi
