#!/usr/bin/env bash
# Package: cage 0.1.4-4, libwlroots10 0.15.1-6 (Debian 12), on wlroots' headless back end.
# Behaviour: the compositor exits with 0 if its client exited with 3, and also if a signal killed the client.
# cage 0.2.0 (Debian 13) passes both on.
# Expected: the client's exit code, as from env, timeout or xinit; or at least not that of a success.
# Why it matters: a kiosk's unit with Restart=on-failure is not started again after its program crashed, and the
# display stays black. Use Restart=always under this version.
# Seen:
#   exit 3: 0; killed: 0
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
# ended COMMAND: the compositor's exit code, with that client.
ended() {
    local status=0
    "${as_user[@]}" env XDG_RUNTIME_DIR="$PWD/run" LD_LIBRARY_PATH="$PWD/usr/lib/x86_64-linux-gnu" WLR_BACKENDS=headless \
        WLR_RENDERER=pixman WLR_LIBINPUT_NO_DEVICES=1 timeout 30 usr/bin/cage -- sh -c "$1" >/dev/null 2>&1 || status=$?
    echo "$status"
}
saw="exit 3: $(ended 'exit 3'); killed: $(ended 'kill -KILL $$')"
echo "saw: $saw"
[ "$saw" = "exit 3: 0; killed: 0" ]
