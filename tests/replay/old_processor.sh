#!/usr/bin/env bash
# The stored sessions replay to the bit on a processor of 2008, which has neither AVX nor fused multiply-add:
# old_processor.sh QEMU ONGGI SESSION... QEMU: its emulation of a program.
set -euo pipefail
qemu=$1 onggi=$2
shift 2
for session in "$@"; do "$qemu" -cpu Nehalem "$onggi" replay "$session" --validate; done
