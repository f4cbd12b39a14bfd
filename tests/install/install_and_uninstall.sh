#!/usr/bin/env bash
# Installs into a non-empty folder, uses the installed files, uninstalls, and compares.
# install_and_uninstall.sh BUILD FOLDER
set -euo pipefail
build=$1 folder=$2
fail() { printf '%s\n' "$*"; exit 1; }
tree() { (cd "$folder/root" && find . -printf '%y %m %p %l\n' | sort && find . -type f -exec sha256sum {} + | sort); }

rm -rf "$folder" "$build/install_folders.txt"
# A machine with some of the folders, one of them empty, and foreign files beside the program's.
mkdir -p "$folder/root/usr/bin" "$folder/root/usr/lib/udev/rules.d" "$folder/root/usr/lib/systemd/system" \
    "$folder/root/etc/security/limits.d"
echo other >"$folder/root/usr/lib/udev/rules.d/60-other.rules"
echo other >"$folder/root/etc/security/limits.d/other.conf"
tree >"$folder/before"

export DESTDIR=$folder/root
cmake --install "$build" --prefix /usr >"$folder/log"
# A second time, as for an update: the folders exist now, and an uninstall must still remove them.
cmake --install "$build" --prefix /usr >>"$folder/log"
unset DESTDIR
root=$folder/root
for file in usr/bin/onggi usr/lib/onggi/kiosk usr/lib/systemd/system/onggi-kiosk.service \
    usr/lib/systemd/system/onggi-share.service usr/lib/sysusers.d/onggi.conf \
    usr/lib/tmpfiles.d/onggi.conf usr/lib/udev/rules.d/70-onggi.rules usr/lib/udev/rules.d/71-onggi-kiosk.rules \
    usr/share/onggi/kiosk.toml usr/share/onggi/heritage/targets.csv usr/share/onggi/gestures/attract.csv \
    usr/share/man/man1/onggi.1.gz usr/share/man/man5/kiosk.toml.5.gz usr/share/man/man8/onggi-kiosk.8.gz \
    usr/share/metainfo/onggi.metainfo.xml usr/share/bash-completion/completions/onggi \
    usr/share/onggi/tools/stick.glb usr/share/onggi/workshop/room.glb etc/security/limits.d/70-onggi.conf; do
    [ -s "$root/$file" ] || fail "expected $file, found none"
done
cmp assets/udev/70-onggi.rules "$root/usr/lib/udev/rules.d/70-onggi.rules"
[ -x "$root/usr/lib/onggi/kiosk" ] || fail "expected a starter that can be run"
bash -n "$root/usr/lib/onggi/kiosk"
said=$(ONGGI_QUARTER_TURNS=5 "$root/usr/lib/onggi/kiosk" start 2>&1) && fail "expected no start with five quarter turns"
[ "$said" = "kiosk: expected 0 to 3 in ONGGI_QUARTER_TURNS, found '5'" ] || fail "expected to be told so, found: $said"
if grep -rn '@[A-Z_]*@' "$root/usr/lib/systemd" "$root/usr/lib/tmpfiles.d" "$root/usr/lib/onggi"; then
    fail "expected every place filled in"
fi
# The installed program finds its installed assets, museums' pots and a workshop, not the source tree's.
"$root/usr/bin/onggi" --version
(cd "$folder" && "$root/usr/bin/onggi" throw "$OLDPWD/assets/gestures/touch-still.csv" --clay studio --target nearest \
    --stats stats.json >/dev/null)
# The demonstrations, each complete.
while read -r name _; do
    [ -z "$name" ] || "$root/usr/bin/onggi" replay "$root/usr/share/onggi/demonstrations/$name.onggi" --validate >/dev/null ||
        fail "expected the installed demonstration '$name' to replay"
done <assets/demonstrations/shown.txt
grep -q '"target"' "$folder/stats.json" || fail "expected a score against a museum's pot"

DESTDIR=$root cmake --build "$build" --target uninstall >>"$folder/log"
tree >"$folder/after"
diff "$folder/before" "$folder/after" || fail "expected the folder as it was before"
echo "installed, used and uninstalled: nothing left behind"
