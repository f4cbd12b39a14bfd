#!/usr/bin/env bash
# Package: python3-pint 0.19.2-1; units 2.22-2 (Debian 12).
# Behaviour: two libraries of units read a blank as a multiplication. For pint 5 3/8 in is 5 times 3/8 inches, 1.875, and
# 20 cm 3 mm an area; GNU units binds the blank before the stroke, takes the inch into the denominator, and refuses.
# Expected: five inches and three eighths, as every label in inches means it; or both refuse.
# Why it matters: collections write heights in such fractions. 1.875 in is a length, so no check of dimensions objects, and
# a bowl of 13.65 cm is printed at 4.76. Read the whole number and the fraction apart, and add them.
# Seen:
#   pint: 4.7625 centimeter, 60 centimeter * millimeter; units: conformability error; of 5+3|8: 13.6525
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download python3-pint=0.19.2-1 units=2.22-2
for package in *.deb; do dpkg-deb -x "$package" .; done
export PYTHONPATH=$folder/usr/lib/python3/dist-packages
cat >read.py <<'CODE'
import pint
unit = pint.UnitRegistry()
print(f'{unit("5 3/8 in").to("cm")}, {unit("20 cm 3 mm")}')
CODE
# in_cm LENGTH: by GNU units.
in_cm() { ./usr/bin/units -f "$PWD/usr/share/units/definitions.units" -t "$1" cm 2>/dev/null | head -1 || true; }
saw="pint: $(/usr/bin/python3 -W ignore read.py); units: $(in_cm '5 3/8 in'); of 5+3|8: $(in_cm '(5+3|8) in')"
echo "saw: $saw"
[ "$saw" = "pint: 4.7625 centimeter, 60 centimeter * millimeter; units: conformability error; of 5+3|8: 13.6525" ]
