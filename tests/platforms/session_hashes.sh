#!/usr/bin/env bash
# Replays all stored sessions on every platform and prints the hashes of their last states as one table:
# session_hashes.sh [PLATFORM...], as in `platforms` below; all by default. Exit code 1 if two platforms differ, or one
# differs from the recordings. Hashes are kept in build/platforms/hashes. Needs root, and the network for packages.
# session_hashes.sh of PRESET [EMULATOR WORD...]: builds and prints the hashes here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
here=$(. /etc/os-release && echo "$VERSION_CODENAME")
platforms=("$here-gcc" "$here-clang" trixie-gcc trixie-clang old-x86 arm64)

hashes_of() {
    local preset=$1
    shift
    if [ "$preset" = arm64 ]; then
        tests/platforms/arm64.sh session_hashes
    else
        source .ci/setup.sh
        install_packages "${packages_to_run[@]}" "${packages_to_check[@]}"
        build "$preset" -DONGGI_TESTS=ON -- session_hashes
    fi
    "$@" "build/$preset/tests/session_hashes" assets/demonstrations/*.onggi tests/replay/sessions/*.onggi
}
in_suite() { tests/platforms/in_suite.sh "$1" "build/platforms/$1" tests/platforms/session_hashes.sh of "$2"; }

if [ "${1:-}" = of ]; then
    hashes_of "${@:2}"
    exit
fi
[ $# -eq 0 ] || platforms=("$@")
hashes=build/platforms/hashes
rm -rf "$hashes"
mkdir -p "$hashes"
for platform in "${platforms[@]}"; do
    case $platform in
    "$here-gcc") run=(hashes_of release) ;;
    "$here-clang") run=(hashes_of clang) ;;
    trixie-gcc) run=(in_suite trixie release) ;;
    trixie-clang) run=(in_suite trixie clang) ;;
    old-x86) run=(hashes_of release qemu-x86_64 -cpu Nehalem) ;;
    arm64) run=(tests/platforms/in_suite.sh "$here" build/platforms/arm64 tests/platforms/session_hashes.sh of arm64 qemu-aarch64) ;;
    *) echo "session_hashes.sh: expected one of ${platforms[*]}, found '$platform'" >&2; exit 2 ;;
    esac
    ("${run[@]}") >"$hashes/$platform.log" 2>&1 || { cat "$hashes/$platform.log"; exit 1; }
    grep -E '^[0-9a-f]{16} ' "$hashes/$platform.log" >"$hashes/$platform"
done
# A row for each session, a column for each platform.
awk -v names="${platforms[*]}" '
    FNR == 1 { column++ }
    column == 1 { sessions[++rows] = $2 }
    { hash[$2, column] = $1 }
    END {
        count = split(names, name, " ")
        head = "| session |"; rule = "|---|"
        for (at = 1; at <= count; at++) { head = head " " name[at] " |"; rule = rule "---|" }
        print head; print rule
        for (row = 1; row <= rows; row++) {
            line = "| `" sessions[row] "` |"
            for (at = 1; at <= count; at++) {
                line = line " " hash[sessions[row], at] " |"
                if (hash[sessions[row], at] != hash[sessions[row], 1]) differs = 1
            }
            print line
        }
        exit differs
    }' "${platforms[@]/#/$hashes/}"
