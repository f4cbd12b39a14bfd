#!/usr/bin/env bash
# systemd-analyze has nothing to say about the units, each says all of unit_lines.txt, and every line that is taken out is
# missed. verify_unit.sh BUILD FOLDER
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
build=$1 folder=$2
command -v systemd-analyze >/dev/null || { echo "skipped: no systemd-analyze (Debian: systemd)"; exit 77; }
rm -rf "$folder"
mkdir -p "$folder"
# For real, not under DESTDIR: the program that the unit starts has to stand where the unit says.
cmake --install "$build" --prefix "$folder/usr" >"$folder/log"
units=$folder/usr/lib/systemd/system
# Its exit code is 0 even for a key that nobody knows, so its silence is what counts.
verify() { systemd-analyze verify --man=no "$1" 2>&1 || true; }
# How much of the machine it could reach by systemd's own reckoning, 0 to 10; the least of services score 9.
exposure() {
    systemd-analyze security --offline=true --no-pager "$1" 2>/dev/null | sed -n 's/.*exposure level.*: \([0-9.]*\).*/\1/p'
}
# expected NAME: the lines of it, at the places of this installation.
expected() {
    local etc
    etc=$(sed -n 's|^LoadCredential=kiosk.toml:\(.*\)/onggi/kiosk.toml|\1|p' "$units/onggi-share.service")
    sed -n "s|^$1 ||p" "$here/unit_lines.txt" | sed "s|@ETC@|$etc|; s|=@/|=$folder/usr/|"
}
# missing NAME UNIT: what the unit does not say of it, if anything.
missing() { expected "$1" | grep -vxFf "$2" || true; }

# check_unit NAME KEY WRONG MOST: silent about it, though not with WRONG in the place of KEY; reaches no more than MOST.
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
        [ -n "$(missing "$1" "$without")" ] || { echo "nobody would miss '$line' in $unit; expected it in unit_lines.txt"; exit 1; }
        awk -v found="$(exposure "$without")" -v before="$reach" 'BEGIN { exit !(found > before) }' && worse=$((worse + 1))
    done < <(sed -n '/^\[Service\]/,/^\[Install\]/{/^[A-Z].*=/p}' "$unit")
    echo "$1: exposure $reach; each of $lines lines is missed, $worse by systemd's reckoning too"
}
check_unit onggi-kiosk WatchdogSec WatchdogSeconds 2.6
check_unit onggi-share LoadCredential LoadCredentials 1.6
