#!/usr/bin/env bash
# installed_kills.sh BUILD FOLDER: installs the program into FOLDER, and kills it there at random moments of visits that
# keep pots. ONGGI_KILLS says how often.
set -euo pipefail
build=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"
DESTDIR=$folder/root cmake --install "$build" --prefix /usr >"$folder/log"
export ONGGI_INSTALLED=$folder/root/usr/bin/onggi
# A build's program would also work with the source tree's assets.
[ -s "$folder/root/usr/share/onggi/kiosk.toml" ]
exec bash "$(dirname "${BASH_SOURCE[0]}")/../window/with_display.sh" "$folder/display" \
    "$build/tests/killed_kiosk" --gtest_filter='*Killed*'
