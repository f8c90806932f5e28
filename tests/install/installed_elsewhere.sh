#!/usr/bin/env bash
# Installs a build into a folder, moves it, and uses the program from there: installed_elsewhere.sh CMAKE BUILD
set -euo pipefail
cmake=$1 build=$2
source=$(cd "$(dirname "$0")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$*" >&2 && exit 1; }
unset FLIPSIDE_ASSETS

"$cmake" --install "$build" --prefix "$folder/first" > /dev/null
mv "$folder/first" "$folder/moved"
cd "$folder/moved"
flipside=bin/flipside

version=$(sed -n 's/^project(flipside VERSION \([0-9.]*\) .*/\1/p' "$source/CMakeLists.txt")
[[ $("$flipside" --version) == "$version" ]] || fail "--version is not $version: $("$flipside" --version)"

# One version and one date wherever they are written.
released=$(sed -n 's/^set(FLIPSIDE_RELEASED \([0-9-]*\)).*/\1/p' "$source/CMakeLists.txt")
grep -q "<release version=\"$version\" date=\"$released\"/>" share/metainfo/*.xml || fail "AppStream: another release"
grep -q "^\.TH FLIPSIDE 1 $released \"flipside $version\"" share/man/man1/flipside.1 || fail "man page: another release"
changelog=$source/packaging/debian/changelog
[[ $(head -n 1 "$changelog") == "flipside ($version) "* ]] || fail "changelog: another version"
[[ $(sed -n 's/^ -- .*>  //p' "$changelog" | head -n 1 | date -u -f - +%F) == "$released" ]] || fail "changelog: another date"

# What a desktop starts and shows is there.
entry=share/applications/org.flipside.Flipside.desktop
"$flipside" $(sed -n 's/^Exec=flipside //p' "$entry") --help > /dev/null
[[ -f share/icons/hicolor/scalable/apps/$(sed -n 's/^Icon=//p' "$entry").svg ]] || fail "there is no icon"

# Its scenes are the ones beside it, not those of the source tree.
sed -i 's/"about": "/"about": "Installed. /' share/flipside/scenes/drop.json
"$flipside" scenes | grep -q 'Installed\.' || fail "the scenes are not those that were installed"
"$flipside" run pinball --engine custom --seconds 1 --out "$folder/installed.csv" 2> /dev/null
"$build/src/app/flipside" run pinball --engine custom --seconds 1 --out "$folder/built.csv" 2> /dev/null
cmp "$folder/installed.csv" "$folder/built.csv"
"$flipside" lessons | grep -q '^01-one-frame ' || fail "there are no lessons"
[[ -f share/flipside/scene.schema.json ]] || fail "there are no schemas"

"$flipside" certify drop --seconds 0.5 --out "$folder/run.json" 2> /dev/null
bin/flipside_check_certificate "$folder/run.json" | grep -q '^accepted' || fail "the check of certificates rejects"

# The example of an engine builds against the header that was installed, and the program takes it.
"$cmake" -G Ninja -S share/doc/flipside/examples/engine-in-c -B "$folder/engine" -D FLIPSIDE_INCLUDE="$PWD/include" > /dev/null
"$cmake" --build "$folder/engine" > /dev/null
"$flipside" run drop --engine "$folder/engine/libengine-in-c.so" --seconds 0.1 --stats "$folder/stats.json"
[[ -s $folder/stats.json ]] || fail "the example of an engine does not run"

# Nothing that was installed names a folder of the machine that built it. Only whole paths count: where the source lies in
# /flipside, share/flipside does not name it.
names_folder() { LC_ALL=C grep -rlaP "(?:(?<![\w./-])|(?<=-[IL]))\Q$1\E(?![\w.-])" .; }
echo "-I$source/src" > leak && [[ $(names_folder "$source") == ./leak ]] || fail "a folder's name would not be found"
rm leak
if names_folder "$build" || names_folder "$source"; then fail "these name the build's or the source's folder"; fi

# Without its assets it says so, and how to name them.
mv share/flipside "$folder/assets"
"$flipside" scenes 2> "$folder/error" && fail "scenes were found that are not there"
grep -q 'FLIPSIDE_ASSETS' "$folder/error" || fail "it does not say what to set: $(cat "$folder/error")"
FLIPSIDE_ASSETS=$folder/assets "$flipside" scenes | grep -q '^pinball$'
