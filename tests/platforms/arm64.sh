#!/usr/bin/env bash
# Compiles the program, its tests and its package for arm64 by Debian's cross compiler, and runs under qemu-user all tests
# that start no other program and draw nothing: arm64.sh, from the root of the checkout. It adds the architecture to dpkg,
# so it belongs in a root of its own (in_suite.sh).
set -euo pipefail
source .ci/setup.sh
dpkg --add-architecture arm64
install_packages crossbuild-essential-arm64 "${packages_to_run[@]}" "${packages_to_check[@]}"
libraries=()
for name in "${packages_to_run[@]}" "${packages_to_check[@]}"; do
    case $name in
        glslang-dev | xserver-xorg-dev) ;;  # its programs take the place of this machine's; for a test's driver of Xorg
        *-dev) libraries+=("$name") ;;
    esac
done
list=$(printf ', %s' "${libraries[@]}")
say "installing libraries for arm64"
apt-get -qq -a arm64 satisfy -y --no-install-recommends "${list:2}" >/dev/null
build arm64 -DONGGI_TESTS=ON
