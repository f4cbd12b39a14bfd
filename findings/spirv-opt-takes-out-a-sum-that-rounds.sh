#!/usr/bin/env bash
# Package: glslang-tools 12.0.0-2, spirv-tools 2023.1-2 (Debian 12).
# Behaviour: of (a + 12582912.0) - 12582912.0, which rounds a to a whole number, spirv-opt -O leaves a; of a * 0.0, which is
# not a number where a is infinite, it leaves 0. With `precise` the sums stay.
# Expected: the arithmetic that the module states. Compilers of C change it on demand only (-ffast-math).
# Why it matters: steps of a drawn groove, noise from fractions and compensated sums differ between a build with -O
# (also glslc -O) and one without. Mark such sums `precise`.
# Seen:
#   plain: sums 2 to 0, products 1 to 0; precise: sums 2 to 2
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download glslang-tools=12.0.0-2 spirv-tools=2023.1-2
for package in *.deb; do dpkg-deb -x "$package" .; done
# compiled EXPRESSION [precise]: writes before.txt and after.txt, the module without and with spirv-opt -O.
compiled() {
    printf '#version 450\nlayout(location = 0) in float a;\nlayout(location = 0) out float o;\n%s\n' \
        "void main() { ${2:-} float sum = $1; o = sum; }" >one.frag
    usr/bin/glslangValidator --quiet -V one.frag -o one.spv
    usr/bin/spirv-opt -O one.spv -o two.spv
    usr/bin/spirv-dis one.spv >before.txt
    usr/bin/spirv-dis two.spv >after.txt
}
# left INSTRUCTIONS: how many there were and are.
left() { echo "$(grep -cE "$1" before.txt || true) to $(grep -cE "$1" after.txt || true)"; }
sum='(a + 12582912.0) - 12582912.0'
compiled "$sum"
saw="plain: sums $(left 'OpF(Add|Sub)')"
compiled 'a * 0.0'
saw+=", products $(left OpFMul)"
compiled "$sum" precise
saw+="; precise: sums $(left 'OpF(Add|Sub)')"
echo "saw: $saw"
[ "$saw" = "plain: sums 2 to 0, products 1 to 0; precise: sums 2 to 2" ]
