#!/usr/bin/env bash
# `onggi live` at 4 kHz in a real window that is resized all the time; the first run refuses every output
# file. Nothing may crash, latch a fault or lose a record, and misses are counted. A few seconds in ./check;
# for the long run ONGGI_SOAK_SECONDS=600. It starts its own display: live_soak.sh ONGGI GESTURE FOLDER If a
# slow or busy machine draws too few frames, the test repeats for twice as long, at half the rate and in a
# window half as wide and high.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/display.sh"
onggi=$1
gesture=$2
rm -rf "$3"
mkdir -p "$3"
cd "$3"

live=
server=
trap 'kill $live $server 2>/dev/null || true' EXIT
open_display . 1280x720
fail() { printf '%s\n' "$*"; cat live.log; exit 1; }

# No byte may be written: the run continues to its end, the file is missing, and the exit code reports the
# lack.
set +e
(ulimit -f 0; exec "$onggi" live "$gesture" --headless --size 64x36 --rate 4000 --seconds 1 --stats full.json) \
    2>&1 | cat >full.log
code=${PIPESTATUS[0]}
set -e
[ "$code" = 3 ] || { cat full.log; echo "disk full: expected exit code 3, found $code"; exit 1; }
[ ! -e full.json ] || { echo "disk full: expected no file, found one"; exit 1; }

# number NAME: the first number of that name in the stats.
number() { grep -o "\"$1\": *[-0-9.e+]*" stats.json | head -1 | sed 's/.*: *//'; }
at_least() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a >= b) }'; }

longest_frame_ms() { tr -d ' \n' <stats.json | sed -n 's/.*"frame_ms":{[^}]*"max":\([0-9.e+]*\).*/\1/p'; }

# soak EASIER: a run in a window that is resized all the time, EASIER times as easy, with the checks that must
# pass on any machine.
soak() {
    local easier=$1 window=
    local seconds=$((easier * ${ONGGI_SOAK_SECONDS:-10})) rate=$((4000 / easier))
    local ran largest kept_ms
    resizes=0
    rm -f stats.json
    "$onggi" live "$gesture" --clay paper --rate "$rate" --seconds "$seconds" --size $((640 / easier))x$((360 / easier)) --stats stats.json >live.log 2>&1 &
    live=$!
    while [ -z "$window" ]; do
        kill -0 "$live" 2>/dev/null || break
        window=$(xdotool search --name '^Onggi' 2>/dev/null | head -1 || true)
        [ -n "$window" ] || sleep 0.1
    done
    while kill -0 "$live" 2>/dev/null; do
        resizes=$((resizes + 1))
        xdotool windowsize "$window" $(((320 + 97 * resizes % 700) / easier)) $(((180 + 53 * resizes % 500) / easier)) 2>/dev/null || true
        sleep 0.2
    done
    wait "$live" || fail "expected exit code 0, found $?"
    live=
    [ -s stats.json ] || fail "no stats"
    [ "$(number faults)" = 0 ] || fail "expected no fault, found $(number faults)"
    # Records are read after each frame, and at most 16384 are kept until then: the longest allowed frame,
    # with a margin.
    kept_ms=$((16384 * 1000 / rate - 100))
    [ "$(number dropped_records)" = 0 ] || at_least "$(longest_frame_ms)" "$kept_ms" ||
        fail "expected no lost record, found $(number dropped_records), and no frame longer than $(longest_frame_ms) ms"
    ran=$(awk -v t="$(number ticks)" -v s="$(number skipped_periods)" 'BEGIN { print t + s }')
    at_least "$ran" $((rate * seconds - 2)) ||
        fail "expected every period run or counted, found $ran in $seconds s"
    # The largest force ever sent to the device: within its limit, apart from rounding.
    largest=$(number largest_force_n)
    at_least "$largest" "$(number mean_force_n)" || fail "largest force $largest N, mean force $(number mean_force_n) N"
    awk -v a="$largest" -v b="$(number most_force_n)" 'BEGIN { exit !(a >= 0 && a <= b * (1 + 1e-9)) }' ||
        fail "expected at most $(number most_force_n) N ever, found $largest N"
    echo "soak: $seconds s at $rate Hz, $resizes resizes, $(number ticks) ticks, $(number missed_deadlines) missed, \
largest force $largest N of $(number most_force_n), gain $(number gain), watchdog $(number silences), frames $(number frames)"
}

# Whether the last run was long enough to count; `lacks` says what was missing.
has_tried() {
    lacks=
    at_least "$resizes" 5 || lacks="only $resizes resizes"
    at_least "$(number ticks)" 100 || lacks="only $(number ticks) ticks"
    at_least "$(number frames)" 10 || lacks="only $(number frames) frames"
    [ "$(number dropped_records)" = 0 ] || lacks="a frame of $(longest_frame_ms) ms, for which no records are kept"
    at_least "$(number mean_force_n)" 0.001 || lacks="clay that pushes with $(number mean_force_n) N"
    [ -z "$lacks" ]
}

for easier in 1 2 4 8; do
    soak "$easier"
    ! has_tried || exit 0
    echo "nothing was tried: $lacks"
done
fail "expected a run that tries something, found $lacks"
