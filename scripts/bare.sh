#!/usr/bin/env bash
# Tries both commands of README.md on a release of Debian, from nothing: scripts/bare.sh bookworm|trixie [--all]
# Makes a bare system by debootstrap, clones HEAD into it, runs ./run.sh and ./test.sh there (with --all: ./test.sh --all)
# and prints exit codes and times. Needs root, debootstrap and 6 GB in ${TMPDIR:-/var/tmp}; mirror and proxy are those of
# this machine's apt. Exit code 0 where both commands had it, else 1.
set -euo pipefail
cd "$(dirname "$0")/.."

usage() { echo "usage: $0 bookworm|trixie [--all]" >&2 && exit 2; }
case "${1:-}" in bookworm | trixie) release=$1 ;; *) usage ;; esac
case "${*:2}" in '') tests='./test.sh' ;; --all) tests='./test.sh --all' ;; *) usage ;; esac
if ((EUID != 0)); then echo "$0: needs root" >&2 && exit 1; fi
if ! command -v debootstrap >/dev/null; then echo "$0: needs the package debootstrap" >&2 && exit 1; fi

# Everything mounted or started for the bare system is in namespaces that end with this script, however it ends. So no
# mount in the folder is seen from outside, and nothing is removed through one.
root=$(mktemp -d "${TMPDIR:-/var/tmp}/flipside-$release.XXXXXX")
inside=
clean_up() {
    trap '' INT TERM HUP
    if [[ -n $inside ]]; then
        kill -KILL "$inside" 2>/dev/null || true
        wait "$inside" 2>/dev/null || true
    fi
    if grep -qF " $root" /proc/self/mountinfo; then
        echo "$0: left $root as it is: something is mounted in it" >&2
    else
        rm -rf --one-file-system "$root" || { sleep 2 && rm -rf --one-file-system "$root"; }
    fi
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# In the background, as bash answers signals while it waits, but not while a command runs.
in_namespaces() {
    local code=0
    unshare --mount --pid --fork --kill-child "$@" &
    inside=$!
    wait "$inside" || code=$?
    inside=
    return "$code"
}

# Debian's archives among this machine's sources, with the release in place of its own: "URI SUITE" per line.
archives() {
    local here
    here=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
    apt-get indextargets --format '$(ORIGIN) $(LABEL) $(REPO_URI) $(RELEASE)' 'Created-By: Packages' | sort -u |
        sed -nE "s#^Debian Debian(-Security)? (\S+) $here(-updates|-security)?\$#\2 $release\3#p"
}
# For debootstrap and apt-get alike: this machine's apt's proxies, unless the environment names others.
export_proxies() {
    local protocol variable proxy
    for protocol in http https; do
        variable=${protocol}_proxy proxy=
        eval "$(apt-config shell proxy "Acquire::$protocol::Proxy")"
        if [[ -n $proxy && $proxy != DIRECT && -z ${!variable:-} ]]; then export "$variable=$proxy"; fi
    done
}

make_bare_system() {
    local sources mirror
    sources=$(archives)
    sources=${sources:-http://deb.debian.org/debian $release}
    mirror=$(sed -n "s/ $release\$//p" <<<"$sources" | head -n 1)
    echo "Debian $release from $mirror in $root"
    in_namespaces debootstrap --variant=minbase --include=ca-certificates "$release" "$root" "$mirror"
    chmod 755 "$root"  # mktemp leaves it to root alone, and everything in it with it
    sed 's/^/deb /; s/$/ main/' <<<"$sources" >"$root/etc/apt/sources.list"
    apt-config dump Acquire | grep -E '^Acquire::(https?::|Retries|Check-|ForceIPv)' >"$root/etc/apt/apt.conf.d/80host" ||
        true  # none set
    git clone --quiet --depth 1 "file://$PWD" "$root/flipside"
}

# try COMMAND: runs it in the clone, without anything of this shell's environment; adds a line to the summary.
summary='' all_good=true
try() {
    local started=$SECONDS code=0 proxies=(${http_proxy:+"http_proxy=$http_proxy"} ${https_proxy:+"https_proxy=$https_proxy"})
    printf '\n== %s on Debian %s\n' "$1" "$release"
    in_namespaces bash -c 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"' "$root" \
        /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "${proxies[@]}" bash -c "cd /flipside && $1" || code=$?
    ((code == 0)) || all_good=false
    started=$((SECONDS - started))
    summary+=$(printf '%-14s exit code %d, %d min %02d s' "$1" "$code" $((started / 60)) $((started % 60)))$'\n'
}

export_proxies
make_bare_system
try ./run.sh
try "$tests"
printf '\n== Debian %s, %s\n%s' "$release" "$(git rev-parse --short HEAD)" "$summary"
$all_good
