#!/usr/bin/env bash
# run_fuzzer.sh PROGRAM CORPUS WORK MAX_BYTES: replays the stored corpus, then fuzzes for ONGGI_FUZZ_SECONDS
# (5). A crashing input is left in WORK, named in the last line; the fuzzer's new inputs stay there too.
set -euo pipefail
program=$1 corpus=$2 work=$3 max_bytes=$4
seconds=${ONGGI_FUZZ_SECONDS:-5}
mkdir -p "$work/found"

# One input may take 10 s, longer on a slow machine, and 1 GiB at most: slow or greedy inputs are faults too.
longest_s=$(awk -v slowness="${ONGGI_SLOWNESS:-1}" 'BEGIN { print int(10 * slowness + 0.5) }')
bounds=(-timeout="$longest_s" -rss_limit_mb=1024 -artifact_prefix="$work/")
trap '[ $? = 0 ] || echo "the input is in $work"' EXIT
"$program" "${bounds[@]}" "$corpus"/*
"$program" "${bounds[@]}" -max_len="$max_bytes" -max_total_time="$seconds" -print_final_stats=1 \
    "$work/found" "$corpus"
