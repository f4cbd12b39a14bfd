#!/usr/bin/env bash
# Package: jsonld 9.0.0 (npm); python3-rdflib 6.1.1-1 with python3-isodate, python3-pyparsing (Debian 12).
# Behaviour: a record of Linked Art says "value": 24.0. As RDF, jsonld.js makes it the integer 24, rdflib the double 24.0;
# of 24.5 the one makes the double 2.45E1, the other the double 24.5. The format's algorithm is that of jsonld.js.
# Expected: the same triples from the same file; no integer for a number that is written with a point.
# Why it matters: graphs of two houses never match: hashes and comparisons of triples differ for each size, and a rule that
# asks for a double refuses the round ones only. State the type: "@type": "xsd:decimal" with the value as a text.
# Seen:
#   24.0: integer 24 and double 24.0; 24.5: double 2.45E1 and double 24.5
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund jsonld@9.0.0
apt-get -qq -o APT::Sandbox::User=root download python3-rdflib=6.1.1-1 python3-isodate=0.6.1-1 python3-pyparsing=3.0.9-1 \
    python3-six=1.16.0-4 python3-pkg-resources=66.1.1-1+deb12u2
for package in *.deb; do dpkg-deb -x "$package" .; done
cat >triple.mjs <<'CODE'
import jsonld from 'jsonld';
console.log(await jsonld.toRDF(JSON.parse(process.argv[2]), { format: 'application/n-quads' }));
CODE
cat >triple.py <<'CODE'
import rdflib, sys
print(rdflib.Graph().parse(data=sys.argv[1], format="json-ld").serialize(format="nt"))
CODE
# number: of the triple that is read: type and text.
number() { sed -n 's/.*"\([^"]*\)"^^<[^#]*#\(.*\)> \.$/\2 \1/p'; }
# both VALUE
both() {
    local record="{\"@context\": {\"value\": \"http://example.org/value\"}, \"@id\": \"http://example.org/height\", \"value\": $1}"
    printf '%s: %s and ' "$1" "$(node triple.mjs "$record" | number)"
    PYTHONPATH=$folder/usr/lib/python3/dist-packages /usr/bin/python3 -W ignore triple.py "$record" | number
}
saw="$(both 24.0); $(both 24.5)"
echo "saw: $saw"
[ "$saw" = "24.0: integer 24 and double 24.0; 24.5: double 2.45E1 and double 24.5" ]
