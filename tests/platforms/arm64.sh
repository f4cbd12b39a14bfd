#!/usr/bin/env bash
# Compiles for arm64 by Debian's cross compiler: arm64.sh [TARGET...], from the root of the checkout. Without targets it compiles
# the program, makes its package, and runs tests of the clay, the paper's method, replay and exports under qemu-user. It adds the
# architecture to dpkg, so it belongs in a root of its own (in_suite.sh).
set -euo pipefail
source .ci/setup.sh
dpkg --add-architecture arm64
# Of libraries arm64's alone: libwebsockets-dev cannot be installed for two processors at once.
tools=() libraries=()
for name in "${packages_to_run[@]}" "${packages_to_check[@]}"; do
    case $name in
        glslang-dev | xserver-xorg-dev) tools+=("$name") ;;  # its programs run here; for a test's driver of Xorg
        *-dev) libraries+=("$name") ;;
        *) tools+=("$name") ;;
    esac
done
install_packages crossbuild-essential-arm64 "${tools[@]}"
list=$(printf ', %s' "${libraries[@]}")
say "installing libraries for arm64"
quietly apt-get -qq -a arm64 satisfy -y --no-install-recommends "${list:2}"
if [ $# -gt 0 ]; then
    build arm64 -DONGGI_TESTS=ON -- "$@"
    exit
fi
tests=(export_studio_pots paper_equations replay_sessions replay_start_state earlier_formats unit_clay unit_core
    studio_chaos studio_grips studio_hands studio_joining studio_load studio_pots studio_rings studio_round studio_state studio_tools
    studio_trimming)
build arm64 -DONGGI_TESTS=ON -- onggi "${tests[@]}"
python3 tests/run_tests.py build/arm64 -R "^($(IFS='|'; echo "${tests[*]}"))$"
cpack --config build/arm64/CPackConfig.cmake -B build/arm64/packages
