# shellcheck shell=bash
# A bare Debian by debootstrap in a folder, for scripts/bare.sh and scripts/bare_install.sh, which source it with the release
# in $release: make_bare_system makes it in $root, inside_it runs commands there, and it goes when the script ends. Needs
# root; mirror and proxy are those of this machine's apt.
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
    export_proxies
    sources=$(archives)
    sources=${sources:-http://deb.debian.org/debian $release}
    mirror=$(sed -n "s/ $release\$//p" <<<"$sources" | head -n 1)
    echo "Debian $release from $mirror in $root"
    in_namespaces debootstrap --variant=minbase --include=ca-certificates "$release" "$root" "$mirror"
    chmod 755 "$root"  # mktemp leaves it to root alone, and everything in it with it
    sed 's/^/deb /; s/$/ main/' <<<"$sources" >"$root/etc/apt/sources.list"
    apt-config dump Acquire | grep -E '^Acquire::(https?::|Retries|Check-|ForceIPv)' >"$root/etc/apt/apt.conf.d/80host" ||
        true  # none set
}

# inside_it COMMAND: runs it there by bash, without anything of this shell's environment.
inside_it() {
    local proxies=(${http_proxy:+"http_proxy=$http_proxy"} ${https_proxy:+"https_proxy=$https_proxy"})
    in_namespaces bash -c 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"' "$root" \
        /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "${proxies[@]}" bash -c "$1"
}
