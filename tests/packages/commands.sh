# Every command of the installed program, by the list in its own --help. Sourced by bare_debian.sh, never run.

# onggi_as_visitor WORDS: runs in a folder that any user may write.
onggi_as_visitor() { in_root env -C /tmp/work onggi "$@"; }
leaves() {
    local file
    for file in "$@"; do [ -s "$root/tmp/work/$file" ] || fail "expected $file, found none"; done
}
shown=/usr/share/onggi/demonstrations

run_throw() {
    show onggi_as_visitor throw "$shown/bowl.onggi" --export bowl.glb --target nearest --stats bowl.json --fired glaze \
        --screenshot bowl.png --save again.onggi
    leaves bowl.glb bowl.json bowl.png again.onggi
    grep -q '"target"' "$root/tmp/work/bowl.json" || fail "expected a score against a museum's pot"
    # Must draw the same picture as the checkout's program with the checkout's assets.
    "$build/onggi" throw assets/demonstrations/bowl.onggi --fired glaze --screenshot "$folder/bowl.png" >/dev/null
    cmp "$folder/bowl.png" "$root/tmp/work/bowl.png" || fail "expected the checkout's picture"
    cp "$root/tmp/work/bowl.png" "$folder/installed_bowl.png"
}
run_replay() {
    local name
    while read -r name _; do
        [ -z "$name" ] || show onggi_as_visitor replay "$shown/$name.onggi" --validate
    done <"$root$shown/shown.txt"
}
run_live() {
    show onggi_as_visitor live /usr/share/onggi/gestures/attract.csv --seconds 2 --headless --stats live.json
    leaves live.json
}
run_film() {
    show onggi_as_visitor film "$shown/vase.onggi" --size 160x120 --seconds 1 --quick --out vase.webp
    leaves vase.webp
}
run_share() {
    local port server
    mkdir -p "$root/tmp/work/outbox"
    (exec "${into_root[@]}" env -C /tmp/work onggi share --outbox outbox --listen 127.0.0.1 --port 0) >"$folder/share.log" 2>&1 &
    server=$!
    # It listens before it prints the port.
    for _ in $(seq 600); do
        port=$(sed -n 's/.* port \([0-9]*\).*/\1/p' "$folder/share.log")
        [ -z "$port" ] || break
        kill -0 "$server" || break
        sleep 0.1
    done
    curl -s -o "$folder/share.html" "http://127.0.0.1:$port/" || true
    kill "$server"
    wait "$server" || fail "expected onggi share to end in peace"
    grep -qi '<html' "$folder/share.html" || { cat "$folder/share.log"; fail "expected a page of onggi share's"; }
    echo "# onggi share: a page of $(wc -c <"$folder/share.html") bytes"
}
run_gallery() {
    in_root mkdir -p /tmp/work/old/2026-01-01/pot-001
    cp "$root$shown/bowl.onggi" "$root/tmp/work/old/2026-01-01/pot-001/pot.onggi"
    show onggi_as_visitor gallery export house.zip --gallery old
    show onggi_as_visitor gallery import house.zip --gallery new
    leaves new/2026-01-01/pot-001/pot.onggi
}
run_devices() { show onggi_as_visitor devices; }
# The status of the installed kiosk, which has not been started yet.
run_status() {
    local status=0
    in_root onggi status --json >"$folder/status.json" || status=$?
    [ "$status" -eq 1 ] && grep -q '"state": "never started"' "$folder/status.json" ||
        { cat "$folder/status.json"; fail "expected a wheel that was never started, and exit code 1, found $status"; }
}
run_doctor() { show onggi_as_visitor doctor; }
# Without a display it reports that; visit.sh tests it with one.
run_kiosk() {
    local status=0
    onggi_as_visitor kiosk >"$folder/kiosk_without.log" 2>&1 || status=$?
    [ "$status" -eq 3 ] && grep -q 'expected a display' "$folder/kiosk_without.log" ||
        { cat "$folder/kiosk_without.log"; fail "expected a kiosk that wants a display, and exit code 3, found $status"; }
}

run_every_command() {
    local name commands
    mkdir -p "$root/tmp/work"
    show in_root onggi --version
    commands=$(in_root onggi --help | awk '/^Subcommands:/ { on = 1; next } on && NF { print $1 }')
    [ "$(wc -w <<<"$commands")" -ge 8 ] || fail "expected at least eight commands, found $commands"
    for name in $commands; do
        declare -F "run_$name" >/dev/null || fail "onggi $name: expected a test of the installed command, found none"
        in_root onggi "$name" --help >/dev/null
        "run_$name"
    done
}
