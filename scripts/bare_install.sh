#!/usr/bin/env bash
# Tries a package on a bare Debian: scripts/bare_install.sh bookworm|trixie [PACKAGE]
# Makes a bare system by debootstrap, installs the package there (default: the one in out/), runs the program, opens its
# window under Xvfb and takes a picture of it (out/bare-RELEASE.png), removes it, and says which files are left that were
# not there before. Exit code 0 where all of that worked and nothing is left. Needs root, debootstrap and 3 GB in
# ${TMPDIR:-/var/tmp}.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() { echo "usage: $0 bookworm|trixie [PACKAGE]" >&2 && exit 2; }
case "${1:-}" in bookworm | trixie) release=$1 ;; *) usage ;; esac
(($# <= 2)) || usage
package=${2:-$(ls out/flipside_*.deb)}
[[ -f $package ]] || { echo "$0: there is no $package; scripts/package.sh makes one" >&2 && exit 1; }
# shellcheck source=scripts/bare_system.sh
source scripts/bare_system.sh

stage() { printf '\n== %s\n' "$1"; }
# Every file but what apt, dpkg and the kernel write of their own doings, and caches of those who were told of the new ones.
list_files() {
    find "$root" -xdev \( -path "$root/proc" -o -path "$root/dev" -o -path "$root/tmp" -o -path "$root/var/log" \
        -o -path "$root/var/cache" -o -path "$root/var/lib/apt" -o -path "$root/var/lib/dpkg" \) -prune \
        -o -printf '%P %y %m\n' | LC_ALL=C sort
}
apt='export DEBIAN_FRONTEND=noninteractive && apt-get install -qq -y --no-install-recommends'

make_bare_system
cp "$package" "$root/tmp/flipside.deb"
stage "its dependencies, and what takes a picture"
depends=$(dpkg-deb --field "$package" Depends)
inside_it "apt-get update -qq && $apt xvfb xauth imagemagick x11-apps \
    && $apt $(sed 's/([^)]*)//g; s/|[^,]*//g; s/,/ /g' <<<"$depends")" >"$root/tmp/log" 2>&1 ||
    { tail -n 20 "$root/tmp/log" >&2 && exit 1; }
list_files >"$root/tmp/before"

stage "installed"
inside_it "$apt /tmp/flipside.deb" >"$root/tmp/log" 2>&1 || { tail -n 20 "$root/tmp/log" >&2 && exit 1; }
inside_it "dpkg -s flipside | grep -E '^(Package|Status|Version)'; which flipside"
stage "runs"
inside_it "flipside --version && flipside scenes | head -n 2 && cd /tmp &&
    flipside run pinball --engine custom --seconds 5 --stats stats.json && grep -E 'steps|impacts' stats.json &&
    flipside compare pinball --engines custom,box2d --seconds 2 | head -n 5 &&
    flipside certify drop --seconds 1 --out run.json && flipside_check_certificate run.json"
stage "its window"
mkdir -p out
# What Mesa keeps of its shaders goes elsewhere than into a home.
inside_it "cd /tmp && XDG_CACHE_HOME=/tmp xvfb-run -a -s '-screen 0 1280x800x24' sh -c '
    flipside play pinball --no-settings & window=\$!
    sleep 15; xwd -root -silent > window.xwd; kill \$window; wait \$window'; convert xwd:window.xwd window.png"
cp "$root/tmp/window.png" "out/bare-$release.png"
colours=$(inside_it "identify -format %k /tmp/window.png")
echo "out/bare-$release.png: $colours colours"
((colours > 100)) || { echo "$0: the window is empty" >&2 && exit 1; }

stage "removed"
inside_it "apt-get purge -qq -y flipside" >"$root/tmp/log" 2>&1 || { tail -n 20 "$root/tmp/log" >&2 && exit 1; }
list_files >"$root/tmp/after"
if ! diff "$root/tmp/before" "$root/tmp/after"; then echo "$0: this is left of it (>) or gone (<)" >&2 && exit 1; fi
echo "nothing is left: $(wc -l <"$root/tmp/after") files, as before"
