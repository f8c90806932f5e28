#!/usr/bin/env bash
# What Debian's build costs Box2D: scripts/box2d_without_assertions.sh [--only REGIME] [--rounds N]
# Debian compiles Box2D with its assertions (and -O2). This builds Debian's own source package a second time with -O3
# -DNDEBUG, as this project is built, runs flipside_bench with either library in turn, N rounds (default 3), and prints
# Box2D's own time per ball and step with each, the least of the rounds. That is by the wall clock: leave the machine alone
# meanwhile. Nothing is installed or changed: all is in a folder that goes at the end. Needs g++, cmake, dpkg-dev, and
# Debian's archives.
set -euo pipefail
cd "$(dirname "$0")/.."
only='' rounds=3
usage() { echo "usage: $0 [--only REGIME] [--rounds N]" >&2 && exit 2; }
while (($#)); do
    case "$1" in
        --only) only=${2:-} && [[ -n $only ]] || usage ;;
        --rounds) rounds=${2:-} && [[ $rounds =~ ^[1-9][0-9]?$ ]] || usage ;;
        *) usage ;;
    esac
    shift 2
done
bench=$PWD/build/release/bench/flipside_bench
if [[ ! -x $bench ]]; then
    echo "$0: needs $bench: cmake --preset release -DFLIPSIDE_BENCH=ON && cmake --build --preset release" >&2 && exit 1
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# The source of the version that is installed, by lists of its own, so that the machine's need not name sources.
fetch() {
    local codename version
    codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
    version=$(dpkg-query -W -f '${source:Version}' libbox2d-dev)
    mkdir -p lists/partial cache/archives/partial
    echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $codename main" >sources
    local own=(-qq -o "Dir::Etc::sourcelist=$PWD/sources" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$PWD/lists"
        -o "Dir::Cache=$PWD/cache" -o APT::Sandbox::User=)
    apt-get "${own[@]}" update
    apt-get "${own[@]}" source --download-only "box2d=$version"
    dpkg-source --no-check -x box2d_*.dsc source >/dev/null
    echo "Box2D $version, Debian's source package"
}
(
    cd "$folder"
    fetch
    cmake -S source -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE='-O3 -DNDEBUG' -DBUILD_SHARED_LIBS=ON \
        -DBOX2D_BUILD_TESTBED=OFF -DBOX2D_BUILD_UNIT_TESTS=OFF >/dev/null
    cmake --build build -j "$(nproc)" >/dev/null
)
library=$(dirname "$(find "$folder/build" -name 'libbox2d.so.*' | head -n 1)")
if LD_LIBRARY_PATH=$library ldd "$bench" | grep -q "$library/libbox2d"; then :; else
    echo "$0: flipside_bench does not load $library" >&2 && exit 1
fi
for ((round = 1; round <= rounds; ++round)); do
    "$bench" --repeats 1 ${only:+--only "$only"} >>"$folder/with"
    LD_LIBRARY_PATH=$library "$bench" --repeats 1 ${only:+--only "$only"} >>"$folder/without"
done
# The least of the rounds in column 6, by regime, balls and contender.
echo "| regime | balls | contender | Debian's build, ns | without assertions, ns | ratio |"
echo '|---|---|---|---|---|---|'
awk -F ' *[|] *' '
    $4 !~ /^box2d/ { next }
    { key = "| " $2 " | " $3 " | " $4 " |"; time = $6 + 0 }
    FILENAME ~ /with$/ { if (!(key in with)) keys[++n] = key; if (!(key in with) || time < with[key]) with[key] = time; next }
    !(key in without) || time < without[key] { without[key] = time }
    END { for (i = 1; i <= n; ++i) printf "%s %.3g | %.3g | %.2f |\n", keys[i], with[keys[i]], without[keys[i]], with[keys[i]] / without[keys[i]] }
' "$folder/with" "$folder/without"
