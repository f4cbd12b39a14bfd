#!/usr/bin/env bash
# Runs a command in a clone of this checkout on another suite of Debian: in_suite.sh SUITE FOLDER COMMAND... The clone is
# of the commit and the uncommitted changes. FOLDER keeps the root, the clone with its builds, and downloads between runs. Needs
# root for chroot and mounts, which are in a private namespace and end with it.
set -euo pipefail
if [ -z "${ONGGI_IN_NAMESPACE:-}" ]; then
    [ "$(id -u)" -eq 0 ] || { echo "expected root, who alone may change the root"; exit 1; }
    ONGGI_IN_NAMESPACE=1 exec unshare --mount --pid --fork --kill-child bash "${BASH_SOURCE[0]}" "$@"
fi
suite=$1 cache=$(realpath -m "$2")
root=$cache/root
shift 2
source "$(dirname "${BASH_SOURCE[0]}")/../packages/root.sh"
mount -t proc proc /proc  # of this namespace

[ -e "$cache/is-unpacked" ] || { rm -rf --one-file-system "$root"; unpack_bare_debian; touch "$cache/is-unpacked"; }
# Tests run the clone's program as other users too.
chmod a+x "$root/root"
# Of git, because a copy of the files alone would have no commit to name the packages by.
clone=$root/root/onggi
[ -d "$clone" ] || git clone -q . "$clone"
git -C "$clone" fetch -q "$PWD" HEAD
git -C "$clone" checkout -q -f --detach FETCH_HEAD
git -C "$clone" clean -q -f -d  # files that the last changes added
git diff --binary HEAD >"$cache/changes"
[ ! -s "$cache/changes" ] || git -C "$clone" apply "$cache/changes"

mount_machine
for file in resolv.conf hosts; do
    : >>"$root/etc/$file"
    mount --bind "/etc/$file" "$root/etc/$file"
done
echo "Debian $(cat "$root/etc/debian_version"), commit $(git rev-parse --short HEAD)$([ ! -s "$cache/changes" ] || echo ' and changes')"
in_root env -C /root/onggi HOME=/root "$@"
