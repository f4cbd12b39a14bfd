#!/usr/bin/env bash
# Package: @iiif/parser 2.2.10 (npm).
# Behaviour: upgrade() turns a manifest of IIIF Presentation 2 into one of version 3. The attribution becomes the required
# statement, logo, date and metadata come along; the license, also one of Creative Commons by its own address, is gone,
# and nothing says so.
# Expected: version 3's field rights, which is made for just these addresses; for others a line in the metadata.
# Why it matters: viewers upgrade what they are given. Most museums publish version 2: a work under CC BY comes out without
# the terms that must go with it. Carry the licence over beside the upgrade, or publish version 3.
# Seen:
#   attribution: kept; license: in no field
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund @iiif/parser@2.2.10
cat >upgrade.mjs <<'CODE'
import { upgrade } from '@iiif/parser/upgrader';
const license = 'http://creativecommons.org/licenses/by/4.0/';
const second = {
    '@context': 'http://iiif.io/api/presentation/2/context.json', '@id': 'http://example.org/manifest', '@type': 'sc:Manifest',
    label: 'Moon jar', attribution: 'A Museum', license,
    sequences: [{ '@type': 'sc:Sequence', canvases: [{ '@id': 'http://example.org/canvas', '@type': 'sc:Canvas', label: 'front',
        height: 100, width: 100, images: [] }] }],
};
const third = upgrade(second);
if (third['@context'] !== 'http://iiif.io/api/presentation/3/context.json') throw new Error('not upgraded');
const attribution = JSON.stringify(third.requiredStatement ?? '').includes('A Museum') ? 'kept' : 'lost';
const field = Object.keys(third).find((key) => JSON.stringify(third[key]).includes('creativecommons'));
console.log(`attribution: ${attribution}; license: in ${field ?? 'no field'}`);
CODE
saw=$(node upgrade.mjs)
echo "saw: $saw"
[ "$saw" = "attribution: kept; license: in no field" ]
