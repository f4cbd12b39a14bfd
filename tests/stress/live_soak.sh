#!/usr/bin/env bash
# `onggi live` at 4 kHz in a real window for a while, the window resized all the time, with every file it writes
# refused at first: nothing may crash, latch a fault or lose a record, and misses are counted. A few seconds in
# ./check; for the long run ONGGI_SOAK_SECONDS=600. It brings a display of its own: live_soak.sh ONGGI GESTURE FOLDER
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
onggi=$1
gesture=$2
seconds=${ONGGI_SOAK_SECONDS:-10}
rm -rf "$3"
mkdir -p "$3"
cd "$3"

live=
server=
trap 'kill $live $server 2>/dev/null || true' EXIT
open_display . 1280x720
fail() { printf '%s\n' "$*"; cat live.log; exit 1; }

# No byte may be written: the run goes to its end, the file is missing, and the exit code says what was lacking.
set +e
(ulimit -f 0; exec "$onggi" live "$gesture" --headless --size 64x36 --rate 4000 --seconds 1 --stats full.json) \
    2>&1 | cat >full.log
code=${PIPESTATUS[0]}
set -e
[ "$code" = 3 ] || { cat full.log; echo "disk full: expected exit code 3, found $code"; exit 1; }
[ ! -e full.json ] || { echo "disk full: expected no file, found one"; exit 1; }

"$onggi" live "$gesture" --clay paper --rate 4000 --seconds "$seconds" --size 640x360 --stats stats.json >live.log 2>&1 &
live=$!
resizes=0
for _ in $(seq 600); do
    window=$(xdotool search --name '^Onggi' 2>/dev/null | head -1 || true)
    [ -n "$window" ] && break
    kill -0 "$live" 2>/dev/null || fail "the program ended before its window was there"
    sleep 0.1
done
[ -n "$window" ] || fail "no window after a minute"
while kill -0 "$live" 2>/dev/null; do
    resizes=$((resizes + 1))
    xdotool windowsize "$window" $((320 + 97 * resizes % 700)) $((180 + 53 * resizes % 500)) 2>/dev/null || true
    sleep 0.2
done
wait "$live" || fail "expected exit code 0, found $?"
live=
[ -s stats.json ] || fail "no stats"

# number NAME: the first number of that name in the stats.
number() { grep -o "\"$1\": *[-0-9.e+]*" stats.json | head -1 | sed 's/.*: *//'; }
at_least() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a >= b) }'; }
at_least "$resizes" 5 || fail "only $resizes resizes: nothing was tried"
[ "$(number faults)" = 0 ] || fail "expected no fault, found $(number faults)"
[ "$(number dropped_records)" = 0 ] || fail "expected no lost record, found $(number dropped_records)"
at_least "$(number ticks)" 100 || fail "expected ticks, found $(number ticks)"
at_least "$(number frames)" 10 || fail "expected frames, found $(number frames)"
ran=$(awk -v t="$(number ticks)" -v s="$(number skipped_periods)" 'BEGIN { print t + s }')
at_least "$ran" "$(awk -v s="$seconds" 'BEGIN { print 4000 * s - 2 }')" ||
    fail "expected every period run or counted, found $ran in $seconds s"
at_least "$(number mean_force_n)" 0.001 || fail "expected the clay to push, found $(number mean_force_n) N"
# The largest that the device was ever told, in any tick: within its limit, but for the last bits of a double.
largest=$(number largest_force_n)
at_least "$largest" "$(number mean_force_n)" || fail "largest force $largest N, mean force $(number mean_force_n) N"
awk -v a="$largest" -v b="$(number most_force_n)" 'BEGIN { exit !(a > 0 && a <= b * (1 + 1e-9)) }' ||
    fail "expected at most $(number most_force_n) N ever, found $largest N"
echo "soak: $seconds s, $resizes resizes, $(number ticks) ticks, $(number missed_deadlines) missed, \
largest force $largest N of $(number most_force_n), gain $(number gain), watchdog $(number silences), frames $(number frames)"
