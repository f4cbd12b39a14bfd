#!/usr/bin/env bash
# Why apt cannot install a package is printed, and nothing of apt where it can. Calls .ci/setup.sh with an apt-get and a
# dpkg-query that do nothing: install_packages_test.sh FOLDER
set -euo pipefail
setup=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/.ci/setup.sh
rm -rf "$1"
mkdir -p "$1"
cd "$1"
for name in dpkg-query id apt-get; do
    printf '#!/bin/sh\n%s\n' 'case "$0 $*" in *id*-u) echo 0 ;; *apt-get*install*) echo "one conflicts with another"; exit "$APT_STATUS" ;; esac' >"$name"
    chmod +x "$name"
done
# installs STATUS: what install_packages prints where apt-get install ends so; fails with its exit code.
installs() { APT_STATUS=$1 PATH="$PWD:$PATH" bash -c 'source "$1"; install_packages one another' - "$setup" 2>&1; }

said=$(installs 0)
[ "$said" = 'onggi: installing Debian packages: one another' ] || { echo "expected silence of apt, found: $said"; exit 1; }
status=0
said=$(installs 100) || status=$?
[ "$status" -eq 3 ] || { echo "expected exit code 3, found $status"; exit 1; }
grep -q '^one conflicts with another$' <<<"$said" || { echo "expected apt's reason, found: $said"; exit 1; }
