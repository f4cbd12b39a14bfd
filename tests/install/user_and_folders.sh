#!/usr/bin/env bash
# The user, its groups, its folders and the first settings, created by systemd's tools in a separate root.
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
grep -q '^onggi-share:' "$root/etc/passwd" || { echo "expected a user onggi-share"; exit 1; }
if grep -q '^[^:]*:[^:]*:[^:]*:.*\bonggi-share\b' "$root/etc/group"; then echo "expected onggi-share in no other group"; exit 1; fi
tmpfiles() {
    systemd-tmpfiles --root="$root" --create --prefix=/var/lib/onggi --prefix=/var/lib/onggi-outbox --prefix=/etc/onggi \
        --prefix=/run/onggi-counter
}
tmpfiles
user=$(sed -n 's/^onggi:[^:]*:\([0-9]*\):.*/\1/p' "$root/etc/passwd")
[ "$(stat -c %u "$root/var/lib/onggi")" = "$user" ] || { echo "expected the pots' folder to be onggi's"; exit 1; }
group=$(sed -n 's/^onggi-share:[^:]*:\([0-9]*\):.*/\1/p' "$root/etc/group")
[ "$(stat -c '%u %g %a' "$root/var/lib/onggi-outbox")" = "$user $group 2750" ] || { echo "expected the outbox to be onggi's, for onggi-share to read"; exit 1; }
[ "$(stat -c '%u %g %a %F' "$root/run/onggi-counter")" = "$user $group 620 fifo" ] || { echo "expected a pipe that onggi-share may only write"; exit 1; }
cmp assets/install/kiosk.toml "$root/etc/onggi/kiosk.toml"
# A museum's settings must survive further runs.
echo 'name = "by the window"' >>"$root/etc/onggi/kiosk.toml"
tmpfiles
grep -q 'by the window' "$root/etc/onggi/kiosk.toml" || { echo "expected the museum's settings to stay"; exit 1; }
echo "user, folders and settings are there"
