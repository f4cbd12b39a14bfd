#!/usr/bin/env bash
# compare.sh [CORE [ROUNDS]]: compares a frame of onggi with VTK and three.js, each on the same core (0), at
# 1280x720, in turns: a shared machine has fast and slow seconds, and a round of a few seconds treats all
# alike. The peers draw the smooth pot as a mesh of 256 x 128, one light, no shadow, a plain background; onggi
# draws the whole scene with the light of its room; three.js is also timed with room light, and with only a
# floor under the pot, for information. Prints a table: the middle round's p50, the worst p99 (with so few
# frames a peer's slowest one), the median of the rounds' ratios; exits with 1 if a ratio is below its goal (3
# for VTK, 25 for three.js). Needs a release build, and Debian's python3-vtk9, xvfb, chromium; node, and npm
# ci in tests/web.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
core=${1:-0}
rounds=${2:-5}
here=tests/bench/peers
build=${ONGGI_BUILD:-build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
lacks() { printf 'compare: expected %s, found none\n' "$1" >&2; exit 3; }
[ -x "$build/onggi_bench" ] || lacks "$build/onggi_bench"
/usr/bin/python3 -c 'import vtk' 2>/dev/null || lacks "python3-vtk9"
command -v xvfb-run >/dev/null || lacks "xvfb-run"
[ -d tests/web/node_modules/three ] || lacks "tests/web/node_modules (npm ci in tests/web)"

"$build/onggi" throw assets/gestures/vase.csv --clay paper --profile "$work/profile.csv" 2>/dev/null
/usr/bin/python3 $here/pot_mesh.py "$work/profile.csv" "$work/pot.glb"

export LP_NUM_THREADS=0 LIBGL_ALWAYS_SOFTWARE=1
for round in $(seq "$rounds"); do
    taskset -c "$core" "$build/onggi_bench" --benchmark_filter='^frame/1280x720$' --benchmark_min_time=0.7 \
        --benchmark_format=json >"$work/ours.$round" 2>"$work/ours.log" || { cat "$work/ours.log" >&2; exit 1; }
    taskset -c "$core" xvfb-run -a /usr/bin/python3 $here/vtk_frame.py "$work/pot.glb" 1280 720 20 >"$work/vtk.$round"
    taskset -c "$core" node $here/three_frame.mjs "$work/pot.glb" 1280 720 8 >"$work/three.$round"
    taskset -c "$core" node $here/three_frame.mjs "$work/pot.glb" 1280 720 6 floor >"$work/floor.$round"
    taskset -c "$core" node $here/three_frame.mjs "$work/pot.glb" 1280 720 4 room >"$work/room.$round"
done

/usr/bin/python3 - "$work" "$rounds" <<'PYTHON'
import json, statistics, sys
work, rounds = sys.argv[1], range(1, int(sys.argv[2]) + 1)
benches = [json.load(open(f"{work}/ours.{round}"))["benchmarks"][0] for round in rounds]
ours = [bench["p50_ms"] for bench in benches]
rows = [("onggi, everything on", ours, max(bench["p99_ms"] for bench in benches), None)]
for name, file, wanted in (("VTK 9.1, physically based", "vtk", 3.0), ("three.js, standard material", "three", 25.0),
                           ("three.js, with a floor too", "floor", None),
                           ("three.js, lit by a room too, as ours is", "room", None)):
    times = [[float(line) for line in open(f"{work}/{file}.{round}")] for round in rounds]
    rows.append((name, [statistics.median(of_round) for of_round in times], max(map(max, times)), wanted))
print("| who, one core, 1280x720 | p50 ms | p99 ms | times ours | wanted |\n|---|---|---|---|---|")
enough = True
for name, medians, slowest, wanted in rows:
    ratio = statistics.median(theirs / own for theirs, own in zip(medians, ours))
    enough = enough and (wanted is None or ratio >= wanted)
    print("| %s | %.1f | %.1f | %.1f | %s |" %
          (name, statistics.median(medians), slowest, ratio, "" if wanted is None else "%g" % wanted))
sys.exit(0 if enough else 1)
PYTHON
