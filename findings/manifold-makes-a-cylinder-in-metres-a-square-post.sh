#!/usr/bin/env bash
# Package: manifold-3d 3.5.4 (npm).
# Behaviour: cylinder() and revolve() without a number of segments choose it by the radius in units: an edge is at least 1
# unit long, and a turn is at least 4 segments. A cylinder of radius 50 has 36 sides, one of radius 0.1 has 4.
# Expected: sides by the angle alone, as the default of 10 degrees says, so that a pot has the same shape in every unit.
# Why it matters: glTF counts in metres. A vase of 0.1 m turned there is a square post with 64 % of its volume, a valid
# solid, without a word. Give the segments, or setMinCircularEdgeLength, or turn it in millimetres and scale it.
# Seen:
#   radius 50: 36 sides, 99 % of the volume; radius 0.1: 4 sides, 64 %
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund manifold-3d@3.5.4
cat >turn.mjs <<'CODE'
import Module from 'manifold-3d';
const library = await Module();
library.setup();
const said = [50, 0.1].map((radius) => {
    const solid = library.Manifold.cylinder(3 * radius, radius);
    // A prism of n sides has two triangles a side and n - 2 at each end.
    const sides = (solid.numTri() + 4) / 4;
    const share = solid.volume() / (Math.PI * radius * radius * 3 * radius);
    return `radius ${radius}: ${sides} sides, ${(100 * share).toFixed()} %`;
});
console.log(said.join('; ').replace('%;', '% of the volume;'));
CODE
saw=$(node turn.mjs)
echo "saw: $saw"
[ "$saw" = "radius 50: 36 sides, 99 % of the volume; radius 0.1: 4 sides, 64 %" ]
