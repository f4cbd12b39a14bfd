#!/usr/bin/env bash
# The user, its groups, its folders and the first settings, made by systemd's own tools in a root of their own.
# user_and_folders.sh BUILD FOLDER
set -euo pipefail
build=$1 folder=$2
for tool in systemd-sysusers systemd-tmpfiles; do
    command -v "$tool" >/dev/null || { echo "skipped: no $tool (Debian: systemd)"; exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "skipped: only root may give folders to another user"; exit 77; }
rm -rf "$folder"
root=$folder/root
mkdir -p "$root/etc"
DESTDIR=$root cmake --install "$build" --prefix /usr >"$folder/log"
systemd-sysusers --root="$root"
grep -q '^onggi:.*:/var/lib/onggi:' "$root/etc/passwd" || { echo "expected a user onggi"; exit 1; }
for group in audio input plugdev render video; do
    grep -q "^$group:.*\bonggi\b" "$root/etc/group" || { echo "expected onggi in the group $group"; exit 1; }
done
tmpfiles() { systemd-tmpfiles --root="$root" --create --prefix=/var/lib/onggi --prefix=/etc/onggi; }
tmpfiles
user=$(sed -n 's/^onggi:[^:]*:\([0-9]*\):.*/\1/p' "$root/etc/passwd")
[ "$(stat -c %u "$root/var/lib/onggi")" = "$user" ] || { echo "expected the pots' folder to be onggi's"; exit 1; }
cmp assets/install/kiosk.toml "$root/etc/onggi/kiosk.toml"
# What the museum has set stays, whenever it is run again.
echo 'name = "by the window"' >>"$root/etc/onggi/kiosk.toml"
tmpfiles
grep -q 'by the window' "$root/etc/onggi/kiosk.toml" || { echo "expected the museum's settings to stay"; exit 1; }
echo "user, folders and settings are there"
