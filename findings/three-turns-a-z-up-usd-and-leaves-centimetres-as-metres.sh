#!/usr/bin/env bash
# Package: three 0.183.2 (npm), USDLoader.
# Behaviour: of the two numbers that a USD stage says of its space, the loader applies one. A stage with upAxis Z is turned
# to +Y; one with metersPerUnit 0.01, which is also what a stage without the field means, is not scaled. Nothing that the
# caller gets tells the unit.
# Expected: both, or neither: three.js counts in metres, its glTF twin of the same pot has the right size, and AR needs it.
# Why it matters: a vase of 30 cm from a USDZ in centimetres stands 30 m tall beside one from a GLB, and in an AR session.
# Write USDZ in metres, with metersPerUnit 1.
# Seen:
#   height at 1 m a unit: 30; at 0.01 m: 30; with Z up: 30 in y
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund three@0.183.2
cat >read.mjs <<'CODE'
import { Box3 } from 'three';
import { USDLoader } from 'three/examples/jsm/loaders/USDLoader.js';
// A wall of 10 by 30 units, upright along the stage's axis.
function size(metersPerUnit, upAxis) {
    const top = upAxis === 'Y' ? '(10, 30, 0), (0, 30, 0)' : '(10, 0, 30), (0, 0, 30)';
    const stage = new USDLoader().parse(`#usda 1.0
(
    defaultPrim = "Pot"
    metersPerUnit = ${metersPerUnit}
    upAxis = "${upAxis}"
)
def Xform "Pot"
{
    def Mesh "Wall"
    {
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(0, 0, 0), (10, 0, 0), ${top}]
        uniform token subdivisionScheme = "none"
    }
}
`);
    stage.updateMatrixWorld(true);
    const box = new Box3().setFromObject(stage, true);
    return (box.max.y - box.min.y).toFixed();
}
console.log(`height at 1 m a unit: ${size(1, 'Y')}; at 0.01 m: ${size(0.01, 'Y')}; with Z up: ${size(1, 'Z')} in y`);
CODE
saw=$(node read.mjs)
echo "saw: $saw"
[ "$saw" = "height at 1 m a unit: 30; at 0.01 m: 30; with Z up: 30 in y" ]
