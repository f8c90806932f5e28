# What Flipside needs, in one place, and how it is installed. Sourced by run.sh and test.sh.
# A|B: A where this release of Debian has it, else B.

build_packages=(
    g++ cmake ninja-build pkg-config           # compiler and build
    libbox2d-dev                               # the other engine
    libsfml-dev libimgui-dev libgl-dev         # window, panel
    libpng-dev                                 # pictures
    libcli11-dev                               # command line
    nlohmann-json3-dev libvalijson-dev         # scene files and their schema
    libxxhash-dev                              # checksums of files of measurements
    libmuparser-dev libmd4c-dev                # lessons: what they claim of their figures, their texts
    'libboost1.81-dev|libboost-dev'            # headers only, 1.75 or later
    libmpfi-dev                                # intervals, for the check of certificates
    libgtest-dev librapidcheck-dev             # tests
    fonts-inter fonts-dejavu-core              # what the window writes with
    xvfb xauth libgl1-mesa-dri                 # pictures without a display
    gnuplot-nox                                # the figures of `flipside report`
    xdotool                                    # keys and clicks for the window's tests
)
test_packages=(                                        # only ./test.sh
    chromium                                           # the report's page in a browser
    libchipmunk-dev                                    # a third engine, as a plug-in
    parallel                                           # sweeps and hunts in shards
    ffmpeg                                             # videos of replays
)
package_packages=(                                     # only scripts/package.sh
    dpkg-dev fakeroot lintian                          # the package's dependencies, and Debian's rules for it
    desktop-file-utils appstream                       # what a desktop shows of it
)
gate_packages=(                                        # only ./test.sh --all
    clang-format clang-tidy clang libclang-rt-dev llvm valgrind ccache
    g++-aarch64-linux-gnu qemu-user                    # the golden test for another processor
)

is_installed() { [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null) == installed ]]; }
is_available() { [[ -n $(apt-cache madison "$1") ]]; }

# The first of the alternatives A|B that this release has; where it has none, the last, so that apt-get names it.
preferred() {
    local package
    for package in ${1//|/ }; do
        if is_installed "$package" || is_available "$package"; then break; fi
    done
    echo "$package"
}

missing_packages() {
    local alternatives
    for alternatives in "$@"; do
        is_installed "$(preferred "$alternatives")" || echo "$alternatives"
    done
}

# install_missing PACKAGE...: does nothing where all are there.
install_missing() {
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        echo "$0: this is no Debian. Install what README.md lists under \"Packages\" by your system's means, then:" \
            "cmake --preset release && cmake --build --preset release" >&2
        exit 1
    fi
    local missing alternatives as_root=()
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]})) || return 0
    if ((EUID != 0)); then
        command -v sudo >/dev/null || {
            echo "$0: needs root or sudo to install: ${missing[*]}" >&2
            exit 1
        }
        as_root=(sudo)
    fi
    echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
    as_root+=(env DEBIAN_FRONTEND=noninteractive)
    local log
    log=$(mktemp)
    if ! {
        "${as_root[@]}" apt-get update -q &&
            mapfile -t missing < <(for alternatives in "${missing[@]}"; do preferred "$alternatives"; done) &&
            "${as_root[@]}" apt-get install -qy --no-install-recommends "${missing[@]}"
    } >"$log" 2>&1; then
        tail -n 20 "$log" >&2
        echo "$0: apt-get could not install them (above); README.md lists the packages under \"Packages\"" >&2
        exit 1
    fi
    rm -f "$log"
}

# build PRESET [TARGET...]: configures and builds.
build() {
    cmake --preset "$1" >/dev/null
    cmake --build --preset "$1" ${2:+--target "${@:2}"}
}
