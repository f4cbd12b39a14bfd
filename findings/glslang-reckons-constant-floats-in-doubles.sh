#!/usr/bin/env bash
# Package: glslang-tools 12.0.0-2, spirv-tools 2023.1-2 (Debian 12).
# Behaviour: the constant 16777216.0 + 1.0 - 16777216.0 of type float is 1 in the compiled module, and 1.0e30 * 1.0e30 / 1.0e30
# is 1e30: glslang reckons constants in doubles and rounds once, at the end. Step by step in
# floats the sum is 0 and the product infinite.
# Expected: each step is rounded to the 32 bits of its type, as C and C++ compilers do for constants on such machines.
# Why it matters: a limit or a table moved from a uniform into a `const` changes its value, and a copy of it in C++ that a
# test compares differs. Compute such constants in C++, or state the result.
# Seen:
#   sum: 1, product: 1.00000002e+30
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download glslang-tools=12.0.0-2 spirv-tools=2023.1-2
for package in *.deb; do dpkg-deb -x "$package" .; done
# constant EXPRESSION: its value in the compiled module.
constant() {
    printf '#version 450\nlayout(location = 0) out float o;\nvoid main() { const float one = %s; o = one; }\n' "$1" >one.frag
    usr/bin/glslangValidator --quiet -V one.frag -o one.spv
    usr/bin/spirv-dis one.spv | sed -n 's/.*OpConstant %float //p'
}
saw="sum: $(constant '16777216.0 + 1.0 - 16777216.0'), product: $(constant '1.0e30 * 1.0e30 / 1.0e30')"
echo "saw: $saw"
[ "$saw" = "sum: 1, product: 1.00000002e+30" ]
