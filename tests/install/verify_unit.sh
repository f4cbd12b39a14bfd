#!/usr/bin/env bash
# systemd-analyze reports nothing about the units, each contains all lines of unit_lines.txt, and removing any
# line is noticed. verify_unit.sh BUILD FOLDER
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
build=$1 folder=$2
command -v systemd-analyze >/dev/null || { echo "skipped: no systemd-analyze (Debian: systemd)"; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"
# Installed without DESTDIR, because the unit's program must exist at its path.
cmake --install "$build" --prefix "$folder/usr" >"$folder/log"
units=$folder/usr/lib/systemd/system
# Its exit code is 0 even for an unknown key, so check that it prints nothing.
verify() { systemd-analyze verify --man=no "$1" 2>&1 || true; }
# systemd's exposure score, 0 to 10; an unprotected service scores over 9.
exposure() {
    systemd-analyze security --offline=true --no-pager "$1" 2>/dev/null | sed -n 's/.*exposure level.*: \([0-9.]*\).*/\1/p'
}
# expected NAME: its lines, with the paths of this installation.
expected() {
    local etc
    etc=$(sed -n 's|^LoadCredential=kiosk.toml:\(.*\)/onggi/kiosk.toml|\1|p' "$units/onggi-share.service")
    sed -n "s|^$1 ||p" "$here/unit_lines.txt" | sed "s|@ETC@|$etc|; s|=@/|=$folder/usr/|"
}
# missing NAME UNIT: the lines that the unit lacks.
missing() { expected "$1" | grep -vxFf "$2" || true; }

# check_unit NAME KEY WRONG MOST: expects no report, but one with WRONG in place of KEY; the exposure is at
# most MOST.
check_unit() {
    local unit=$units/$1.service said line reach worse=0 lines=0 without=$folder/onggi-without.service
    said=$(verify "$unit")
    [ -z "$said" ] || { printf 'expected silence about %s, found:\n%s\n' "$unit" "$said"; exit 1; }
    sed "s/^$2=/$3=/" "$unit" >"$folder/onggi-wrong.service"
    [ -n "$(verify "$folder/onggi-wrong.service")" ] || { echo "systemd-analyze let $3= pass in silence"; exit 1; }
    said=$(missing "$1" "$unit")
    [ -z "$said" ] || { printf 'expected in %s:\n%s\n' "$unit" "$said"; exit 1; }
    reach=$(exposure "$unit")
    awk -v found="$reach" -v most="$4" 'BEGIN { exit !(found != "" && found <= most) }' ||
        { echo "expected an exposure of at most $4 for $1, found '$reach'"; exit 1; }
    while read -r line; do
        grep -vxF -- "$line" "$unit" >"$without"
        lines=$((lines + 1))
        [ -n "$(missing "$1" "$without")" ] || { echo "no check would miss '$line' in $unit; expected it in unit_lines.txt"; exit 1; }
        awk -v found="$(exposure "$without")" -v before="$reach" 'BEGIN { exit !(found > before) }' && worse=$((worse + 1))
    done < <(sed -n '/^\[Service\]/,/^\[Install\]/{/^[A-Z].*=/p}' "$unit")
    echo "$1: exposure $reach; each of $lines lines is missed, $worse by systemd's reckoning too"
}
# Debian 12's cage ends with 0 however the wheel ended (findings/cage-exits-0-however-its-client-ended.sh): after a crash
# any other value would leave the display black.
grep -qx 'Restart=always' "$units/onggi-kiosk.service" || { echo "expected Restart=always for the kiosk"; exit 1; }
check_unit onggi-kiosk WatchdogSec WatchdogSeconds 2.6
check_unit onggi-share LoadCredential LoadCredentials 1.6
