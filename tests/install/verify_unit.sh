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
unit=$folder/usr/lib/systemd/system/onggi-kiosk.service
verify() { systemd-analyze verify --man=no "$1" 2>&1 || true; }
said=$(verify "$unit")
[ -z "$said" ] || { printf 'expected silence about the unit, found:\n%s\n' "$said"; exit 1; }
# It would have spoken.
sed 's/^WatchdogSec=/WatchdogSeconds=/' "$unit" >"$folder/onggi-wrong.service"
[ -n "$(verify "$folder/onggi-wrong.service")" ] || { echo "systemd-analyze let an unknown key pass in silence"; exit 1; }
for key in Type=notify NotifyAccess=all WatchdogSec= Restart=always User=onggi LimitRTPRIO= LimitMEMLOCK=infinity \
    'DeviceAllow=char-hidraw rw'; do
    grep -q "^$key" "$unit" || { echo "expected $key in the unit"; exit 1; }
done
echo "the unit is as systemd likes it"
