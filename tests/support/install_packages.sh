#!/usr/bin/env bash
# Installs what is missing of packages.txt. Silent, and needs no network, when nothing is missing.
set -euo pipefail
cd "$(dirname "$0")/../.."
say() { echo "install_packages.sh: $*" >&2; }

installed() { grep -qxF "$1" <<<"$provided"; }
known() { apt-cache show "$1" >/dev/null 2>&1; }

packages=$(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' packages.txt)
if ! command -v apt-get >/dev/null; then
    say "no apt-get here. If the build misses something, this is the list, by Debian's names:" $packages
    exit 0
fi

# An installed package may provide another: nodejs from elsewhere than Debian brings its own npm.
provided=$(dpkg-query -W -f '${db:Status-Status},${Package},${Provides}\n' | grep '^installed,' |
    sed -e 's/([^)]*)//g' | tr ',' '\n' | tr -d ' ' | sort -u)
missing=()
for package in $packages; do
    installed "$package" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        say "not root and no sudo; as root:  apt-get install ${missing[*]}"
        exit 1
    fi
    root=(sudo)
fi
apt() { "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@"; }

say "missing: ${missing[*]}"
apt update -qq || say "apt-get update failed; trying with the lists at hand"

# Other distributions lack some of Debian's packages (Ubuntu has no chromium-common): the tests that need them skip.
wanted=()
for package in "${missing[@]}"; do
    if known "$package"; then
        wanted+=("$package")
    else
        say "not in this system's archive: $package"
    fi
done
[ ${#wanted[@]} -eq 0 ] || apt install -y -qq --no-install-recommends "${wanted[@]}" </dev/null
