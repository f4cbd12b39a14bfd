#!/usr/bin/env bash
# Package: edtf 4.11.1 (npm).
# Behaviour: EDTF writes a season as a month from 21 on: spring 1750 is 1750-21, winter 1750-24. The library bounds them by
# the quarters of the year: spring is January to March, winter October to December. So spring does not hold its own May.
# Expected: spring from March to May, as north of the equator, or a span that says that a season has no sure months; EDTF
# has other codes for quarters (33 to 36), which have the same bounds here.
# Why it matters: a catalogue dates a pot "spring 1750" and is searched by months: May finds nothing, January does.
# Seen:
#   spring 1750: 01-01 to 03-31, with May: false; winter: 10-01 to 12-31; first quarter: 01-01 to 03-31
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund edtf@4.11.1
cat >season.mjs <<'CODE'
import edtf from 'edtf';
const day = (time) => new Date(time).toISOString().slice(5, 10);
const span = (text) => `${day(edtf(text).min)} to ${day(edtf(text).max)}`;
const [spring, may] = [edtf('1750-21'), edtf('1750-05')];
const meets = spring.min <= may.max && may.min <= spring.max;
console.log(`spring 1750: ${span('1750-21')}, with May: ${meets}; winter: ${span('1750-24')}; first quarter: ${span('1750-33')}`);
CODE
saw=$(node season.mjs)
echo "saw: $saw"
[ "$saw" = "spring 1750: 01-01 to 03-31, with May: false; winter: 10-01 to 12-31; first quarter: 01-01 to 03-31" ]
