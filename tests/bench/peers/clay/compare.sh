#!/usr/bin/env bash
# compare.sh [ROUNDS [CORE]]: the tick of the paper's clay and of the studio's beside seven other models, in turns on one core
# (3 rounds, core 0). Prints the versions, and the table of docs/performance.md; draws docs/clay_ticks.svg. Needs a release build,
# and Debian's libbullet-dev, libopenvdb-dev, libtbb-dev, libgetfem-dev, libeigen3-dev and gnuplot-nox. Takes ten minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../../.."
rounds=${1:-3}
core=${2:-0}
here=tests/bench/peers/clay
build=${ONGGI_BUILD:-build/release}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
lacks() { printf 'compare: expected %s, found none\n' "$1" >&2; exit 3; }
[ -f "$build/game/clay/libonggi_clay.a" ] || lacks "$build/game/clay/libonggi_clay.a"
packages=(libbullet-dev libopenvdb-dev libtbb-dev libgetfem-dev libeigen3-dev gnuplot-nox)
for package in "${packages[@]}"; do
    dpkg-query --show "$package" 2>/dev/null | grep '[0-9]' || lacks "$package"
done
g++ --version | head -n 1

printf '%s\n' $here/*.cpp | xargs -P "$(nproc)" -I{} sh -c 'g++ -c "$1" -o "$2/$(basename "$1" .cpp).o" -std=c++20 -O3 \
    -march=native -DNDEBUG -I. -I'$here' -I/usr/include/eigen3 $(pkg-config --cflags bullet)' sh {} "$work"
g++ "$work"/*.o -o "$work/clay_peers" "$build"/game/{clay/libonggi_clay,tool/libonggi_tool}.a "$build"/engine/core/libonggi_core.a \
    -lgetfem -lopenvdb -ltbb -lBulletSoftBody -lBulletDynamics -lBulletCollision -lLinearMath -lfmt
taskset -c "$core" "$work/clay_peers" "$rounds" "$work/ticks.dat"
gnuplot -e "data='$work/ticks.dat'" $here/plot.gp >docs/clay_ticks.svg
