#!/usr/bin/env bash
# Package: @jscad/svg-deserializer 2.5.14, @jscad/modeling 2.13.0 (npm).
# Behaviour: a square of 96 pixels in an SVG becomes 27.09 mm wide: 90 pixels an inch, as drawing programs had before 2016.
# The same square in a drawing whose width is stated, 1in, is 25.4 mm.
# Expected: 25.4 mm in both, since CSS and SVG 2 have 96 pixels an inch.
# Why it matters: a pot's profile that is drawn in pixels comes out 6.7 % larger: a lid no longer fits. State the drawing's
# width in mm, with a viewBox that counts in mm.
# Seen:
#   96 px: 27.09 mm; 96 of a viewBox of 1 inch: 25.40 mm
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund @jscad/svg-deserializer@2.5.14 @jscad/modeling@2.13.0
cat >width.cjs <<'CODE'
const { deserialize } = require('@jscad/svg-deserializer');
const { measurements } = require('@jscad/modeling');
function width(attributes) {
    const drawing = `<svg xmlns="http://www.w3.org/2000/svg" ${attributes}><rect width="96" height="96"/></svg>`;
    const [least, most] = measurements.measureAggregateBoundingBox(...deserialize({ output: 'geometry' }, drawing));
    return `${(most[0] - least[0]).toFixed(2)} mm`;
}
const inch = 'width="1in" height="1in" viewBox="0 0 96 96"';
console.log(`96 px: ${width('width="96" height="96"')}; 96 of a viewBox of 1 inch: ${width(inch)}`);
CODE
saw=$(node width.cjs)
echo "saw: $saw"
[ "$saw" = "96 px: 27.09 mm; 96 of a viewBox of 1 inch: 25.40 mm" ]
