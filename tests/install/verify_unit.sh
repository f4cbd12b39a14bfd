#!/usr/bin/env bash
# systemd-analyze has nothing to say about the unit. Its exit code is 0 even for a key that nobody knows, so its silence
# is what counts. verify_unit.sh BUILD FOLDER
set -euo pipefail
build=$1 folder=$2
command -v systemd-analyze >/dev/null || { echo "skipped: no systemd-analyze (Debian: systemd)"; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"
# For real, not under DESTDIR: the program that the unit starts has to stand where the unit says.
cmake --install "$build" --prefix "$folder/usr" >"$folder/log"
units=$folder/usr/lib/systemd/system
verify() { systemd-analyze verify --man=no "$1" 2>&1 || true; }
# expect_unit NAME KEY WRONG ...: nothing is said of it, WRONG in the place of KEY would have been, the rest stands in it.
expect_unit() {
    local unit=$units/$1 key=$2 wrong=$3 said line
    shift 3
    said=$(verify "$unit")
    [ -z "$said" ] || { printf 'expected silence about %s, found:\n%s\n' "$unit" "$said"; exit 1; }
    sed "s/^$key=/$wrong=/" "$unit" >"$folder/onggi-wrong.service"
    [ -n "$(verify "$folder/onggi-wrong.service")" ] || { echo "systemd-analyze let $wrong= pass in silence"; exit 1; }
    for line in "$@"; do
        grep -q "^$line" "$unit" || { echo "expected $line in $unit"; exit 1; }
    done
}
expect_unit onggi-kiosk.service WatchdogSec WatchdogSeconds Type=notify NotifyAccess=all WatchdogSec= Restart=always \
    User=onggi LimitRTPRIO= LimitMEMLOCK=infinity 'DeviceAllow=char-hidraw rw' ReadWritePaths=-/var/lib/onggi-outbox \
    ReadWritePaths=-/var/lib/prometheus/node-exporter
expect_unit onggi-share.service LoadCredential LoadCredentials User=onggi-share LoadCredential=kiosk.toml: Restart=on-failure \
    'RestrictAddressFamilies=AF_INET AF_INET6$' ProtectHome=yes ProtectSystem=strict NoNewPrivileges=yes \
    'CapabilityBoundingSet=$' InaccessiblePaths=-/var/lib/onggi PrivateDevices=yes
# How much of the machine it could reach by systemd's own reckoning, 0 to 10; the least of services score 9.
exposed=$(systemd-analyze security --offline=true --no-pager "$units/onggi-share.service" 2>/dev/null |
    sed -n 's/.*exposure level.*: \([0-9.]*\).*/\1/p')
awk -v found="$exposed" 'BEGIN { exit !(found != "" && found < 2.0) }' ||
    { echo "expected an exposure below 2.0 for onggi-share, found '$exposed'"; exit 1; }
echo "the units are as systemd likes them"
