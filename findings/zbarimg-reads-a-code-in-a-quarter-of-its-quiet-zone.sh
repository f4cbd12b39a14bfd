#!/usr/bin/env bash
# Package: zbar-tools, libzbar0 0.23.92-7+deb12u1, qrencode, libqrencode4 4.1.1-1 (Debian 12).
# Behaviour: zbarimg reads a QR code of three pixels a module with a light margin of one module inside a black frame, and
# one whose picture ends at its last module. Its XML gives both the quality of a code with the whole margin.
# Expected: nothing is read, or a warning: ISO/IEC 18004 requires four light modules on every side.
# Why it matters: a screen, label or print test that reads its code by zbarimg passes with words or an edge in the
# margin, where phones may fail. Measure the margin in pixels.
# Seen:
#   quality with four modules: 1; with one in a black frame: 1; at the picture's edge: 1
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download zbar-tools=0.23.92-7+deb12u1 libzbar0=0.23.92-7+deb12u1 \
    qrencode=4.1.1-1 libqrencode4=4.1.1-1
for package in *.deb; do dpkg-deb -x "$package" .; done
export LD_LIBRARY_PATH=$PWD/usr/lib/x86_64-linux-gnu
# code MARGIN FRAME: a grey picture (PGM) of the code, with so many light modules around it and dark ones around those.
code() {
    usr/bin/qrencode -t ASCII -m "$1" 'http://192.0.2.1/K73FQ9TX' | awk -v frame="$2" '
        { sub(/\r$/, ""); line[++rows] = $0; if (length($0) > wide) wide = length($0) }
        END {
            wide /= 2
            printf "P2\n%d %d\n255\n", 3 * (wide + 2 * frame), 3 * (rows + 2 * frame)
            for (y = 1 - frame; y <= rows + frame; ++y) for (again = 0; again < 3; ++again) {
                for (x = 1 - frame; x <= wide + frame; ++x) {
                    inside = y >= 1 && y <= rows && x >= 1 && x <= wide
                    dark = !inside || substr(line[y], 2 * x - 1, 1) == "#"
                    for (side = 0; side < 3; ++side) printf "%d ", dark ? 0 : 255
                }
                print ""
            }
        }' >"$1.pgm"
    usr/bin/zbarimg --xml -q "$1.pgm" 2>/dev/null | sed -n "s/.*<symbol type='QR-Code' quality='\([0-9]*\)'.*/\1/p"
}
saw="quality with four modules: $(code 4 0); with one in a black frame: $(code 1 4); at the picture's edge: $(code 0 0)"
echo "saw: $saw"
[ "$saw" = "quality with four modules: 1; with one in a black frame: 1; at the picture's edge: 1" ]
