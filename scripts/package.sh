#!/usr/bin/env bash
# Makes the package for the release of Debian that this machine runs, and checks it: scripts/package.sh [PRESET]
# Builds PRESET (default release), writes out/flipside_VERSION_ARCHITECTURE.deb, and ends with exit code 1 where lintian,
# desktop-file-validate or appstreamcli find an error. scripts/bare_install.sh installs it on a bare system.
set -euo pipefail
cd "$(dirname "$0")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh
preset=${1:-release}
install_missing "${build_packages[@]}" "${package_packages[@]}"
build "$preset" flipside flipside_check_certificate flipside_manual

# The same bytes from the same commit and compiler, whenever it is made.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH
umask 022
mkdir -p out
rm -f out/flipside_*.deb
cpack --config "build/$preset/CPackConfig.cmake" -B out -G DEB >out/cpack.log || { cat out/cpack.log >&2 && exit 1; }
rm -rf out/_CPack_Packages out/cpack.log
deb=$(ls out/flipside_*.deb)

desktop-file-validate packaging/*.desktop
appstreamcli validate --no-net packaging/*.metainfo.xml
lintian --allow-root --fail-on error "$deb"
dpkg-deb --info "$deb" | sed -n 's/^ \(Package\|Version\|Depends\|Installed-Size\)/\1/p'
ls -l "$deb"
