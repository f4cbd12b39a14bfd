#!/usr/bin/env bash
# Package: cage 0.1.4-4, libwlroots10 0.15.1-6 (Debian 12); cage 0.2.0 (Debian 13) does the same.
# Behaviour: the compositor ends when the pipe that its client inherited is closed in every process, not when the client
# ends. A process that the client left behind, without a window and with its standard streams elsewhere, holds it.
# Expected: a compositor for one program ends with that program's process.
# Why it matters: a background helper that a kiosk's program or start script leaves behind keeps an empty screen up, and
# the service manager sees a living main process. Close inherited descriptors above 2 in such a helper.
# Seen:
#   helper holds the pipe: 3 s or more; helper closed it: under 3 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download cage=0.1.4-4 libwlroots10=0.15.1-6
for package in *.deb; do dpkg-deb -x "$package" .; done
mkdir -m 700 run
as_user=()
if [ "$(id -u)" -eq 0 ]; then  # cage refuses root
    chmod a+x .
    chown -R nobody run
    as_user=(setpriv --reuid=nobody --regid=nogroup --clear-groups)
fi
cat >client.sh <<'CODE'
# client.sh holds|closes: ends at once and leaves a helper behind for six seconds.
helper() {
    if [ "$1" = closes ]; then
        for file in /proc/self/fd/*; do
            file=${file##*/}
            [ "$file" -le 2 ] || exec {file}>&-
        done
    fi
    exec sleep 6
}
(helper "$1" </dev/null >/dev/null 2>&1 &)
CODE
# lasted holds|closes: how long the compositor ran.
lasted() {
    local before
    before=$(date +%s)
    "${as_user[@]}" env XDG_RUNTIME_DIR="$PWD/run" LD_LIBRARY_PATH="$PWD/usr/lib/x86_64-linux-gnu" WLR_BACKENDS=headless \
        WLR_RENDERER=pixman WLR_LIBINPUT_NO_DEVICES=1 timeout 30 usr/bin/cage -- bash "$PWD/client.sh" "$1" >/dev/null 2>&1
    [ $(($(date +%s) - before)) -ge 3 ] && echo "3 s or more" || echo "under 3 s"
}
saw="helper holds the pipe: $(lasted holds); helper closed it: $(lasted closes)"
echo "saw: $saw"
[ "$saw" = "helper holds the pipe: 3 s or more; helper closed it: under 3 s" ]
