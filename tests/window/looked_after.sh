#!/usr/bin/env bash
# The status for a museum's monitoring during a visit, and after a crash in the middle of one: looked_after.sh
# ONGGI PROGRAMS FOLDER. The kiosk has a supervisor, as in a museum.
set -euo pipefail

open_supervised() {
    mkdir -p metrics
    grep -q metrics_folder kiosk.toml || printf '[staff]\nname = "by the door"\nmetrics_folder = "metrics"\n' >>kiosk.toml
    "${as_usual[@]}" "$onggi" kiosk --config kiosk.toml --size "$size" --device auto --volume 0 >>kiosk.log 2>&1 &
    kiosk=$!
}
OPENS=open_supervised
source "$(dirname "${BASH_SOURCE[0]}")/visitor.sh"

# says PATTERN...: `onggi status --json` must have a line for each pattern, and the exit code EXPECTED.
says() {
    local status=0 pattern
    "$onggi" status --json --config kiosk.toml >status.json || status=$?
    [ "$status" -eq "$EXPECTED" ] || { cat status.json; fail "expected exit code $EXPECTED of onggi status, found $status"; }
    for pattern in "$@"; do grep -q "$pattern" status.json || { cat status.json; fail "expected $pattern of onggi status"; }; done
}
logged() { grep -qE "$1" kiosk.log || fail "expected a line '$1'"; }

EXPECTED=1 says '"state": "never started"'
begin_visit
EXPECTED=0 says '"well": true' '"name": "by the door"' '"state": "running"' '"starts": 1' '"screen": "attract"'
for line in 'onggi_up 1' 'onggi_well 1' 'onggi_starts_today 1' 'onggi_info{name="by the door",version=".*"} 1'; do
    grep -q "^$line\$" metrics/onggi.prom || fail "expected $line in metrics/onggi.prom"
done
[ "$(stat -c %A metrics/onggi.prom)" = -rw-r--r-- ] || fail "expected metrics that others may read"
press choose free; on_screen throw
press_it
open_it
pause 20  # the journal is synced once a second

# The program crashes.
child=$(pgrep --parent "$kiosk" --exact onggi)
kill -SEGV "$child"
status=0
wait "$kiosk" || status=$?
[ "$status" -eq 1 ] || fail "expected exit code 1 of the supervisor, found $status"
logged '^onggi: crash: SIGSEGV from process [0-9]+ in thread onggi of onggi [0-9.]+ \('
[ "$(grep -cE '^/.*\(.*\) ?\[0x[0-9a-f]+\]$' kiosk.log)" -ge 5 ] || fail "expected a backtrace"
logged '^onggi: crash: the session that led there: /.*/gallery/state/visit-[12]\.onggi\.part$'
logged '^onggi: the kiosk ended with exit code 1$'
EXPECTED=1 says '"state": "fell"' '"it ended with an error or crashed"'
grep -q '^onggi_up 0$' metrics/onggi.prom || fail "expected metrics that say it is down"
logged '^onggi: crash: session kept as gallery/faults/crash-1\.onggi, for onggi replay$'
"$onggi" replay gallery/faults/crash-1.onggi --validate || fail "expected the session of the crash to replay"

# It restarts and reports the crash.
open_kiosk
wait_for "window" xdotool search --name '^Onggi'
on_screen attract
EXPECTED=0 says '"falls": 1' '"starts": 2' 'faults/crash-1.onggi'
logged 'interrupted visit: .* can be resumed'
end_kiosk
wait "$kiosk" || fail "the kiosk ended with exit code $?"
EXPECTED=1 says '"state": "ended"' '"it was ended"'
grep -q '^onggi_up 0$' metrics/onggi.prom || fail "expected metrics that say it is down"
echo "looked after: $(grep -c '^onggi_' metrics/onggi.prom) metrics, a crash kept as a session of $(stat -c %s gallery/faults/crash-1.onggi) bytes"
