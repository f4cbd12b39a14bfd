#!/usr/bin/env bash
# Tests the packages on a bare Debian of this machine's suite: installed by apt, every command run, a visitor at the kiosk under
# cage, an upgrade in the middle of the next visit, a purge. Prints a transcript. bare_debian.sh BUILD
# PACKAGES FOLDER CACHE Needs root for chroot and mounts, which are in a private namespace and end with it.
# There is no systemd: the script does its work according to the unit.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if [ -z "${ONGGI_IN_NAMESPACE:-}" ]; then
    [ "$(id -u)" -eq 0 ] || { echo "SKIPPED: only root may change the root"; exit 77; }
    command -v mmdebstrap >/dev/null || { echo "SKIPPED: no mmdebstrap"; exit 77; }
    export ONGGI_IN_NAMESPACE=1
    exec unshare --mount --pid --fork --kill-child bash "${BASH_SOURCE[0]}" "$@"
fi
build=$1 packages=$2 folder=$3 cache=$4
root=$folder/root
source "$here/root.sh"
source "$here/commands.sh"
source "$here/upgrade.sh"
rm -rf "$folder"
mkdir -p "$folder"
mount -t proc proc /proc  # of this namespace, for kill and pkill

say "a bare Debian, $suite"
unpack_bare_debian
mount_machine
echo "$(cat "$root/etc/debian_version"), $(du -sxm "$root" | cut -f 1) MB, $(in_root dpkg-query -f '.\n' -W | wc -l) packages"
cp "$packages"/onggi*.deb "$root/tmp"
(cd "$root/tmp" && ls -l onggi*.deb | awk '{ print $5, $9 }')

say "apt install ./onggi*.deb"
in_root apt-get -qq update
install_packages "$root"/tmp/onggi*.deb
echo "$(du -sxm "$root" --exclude="$root/var/cache" | cut -f 1) MB, $(in_root dpkg-query -f '.\n' -W | wc -l) packages"
show in_root dpkg-query -W -f '${Package} ${Version} ${Status} ${Installed-Size} kB\n' onggi onggi-kiosk
show in_root id onggi
show in_root stat -c '%A %U:%G %n' /var/lib/onggi /var/lib/onggi-outbox /run/onggi-counter /etc/onggi/kiosk.toml
for unit in onggi-kiosk seatd; do
    in_root systemctl is-enabled "$unit" >/dev/null || fail "expected $unit to start with the machine"
done
[ "$(in_root systemctl is-enabled onggi-share || true)" = disabled ] || fail "expected sharing to wait for its settings"

say "every command"
run_every_command

say "the kiosk, as its unit starts it"
# The staff's settings, which belong to the museum from here on.
sed -i 's/^pin = ""/pin = "2468"/' "$root/etc/onggi/kiosk.toml"
printf '[visit]\nidle_s = 180\nshows_by_itself = false\n\n[languages]\nfirst = "en"\n' >>"$root/etc/onggi/kiosk.toml"
bash "$here/visit.sh" keep "$build" "$root" "$folder/visit"

say "an upgrade while somebody throws"
upgrade_between_two_halves_of_a_visit
say "purge"
purge_but_for_pots
say "done"
