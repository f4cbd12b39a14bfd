# Checks whether a program's memory grows with each repetition of the same actions. Sourced, never run; the
# caller sets `kiosk` to the process, writes its output to kiosk.log, and has fail() of waiting.sh.

# The memory that the program has allocated or shares, kB, without file pages, so that fonts and drivers do not count. The minimum
# over a second, because a thread may hold memory temporarily.
own_memory_kb() {
    for _ in 1 2 3 4 5; do
        awk '$1 == "RssAnon:" || $1 == "RssShmem:" { sum += $2 } END { print sum }' "/proc/$kiosk/status"
        sleep 0.2
    done | sort -n | head -1
}

# holds_no_more TURN...: repeats TURN until the memory is the same after four turns in a row, apart from some
# pages. At first it rises and falls: caches fill, and the picture's quality changes. A leak keeps growing,
# and simultaneous frees cannot hide it for long.
holds_no_more() {
    local most_kb=600 turns=20 kb=() spread_kb
    for _ in $(seq "$turns"); do
        "$@"
        kb+=("$(own_memory_kb)")
        [ "${#kb[@]}" -ge 4 ] || continue
        spread_kb=$(printf '%s\n' "${kb[@]: -4}" | sort -n | awk 'NR == 1 { least = $1 } END { print $1 - least }')
        [ "$spread_kb" -le "$most_kb" ] || continue
        printf 'memory of its own: the same to %s kB after %s turns: %s kB\n' "$spread_kb" "${#kb[@]}" "${kb[*]}"
        return
    done
    fail "expected the same memory, to $most_kb kB, after four turns in a row, found in $turns turns: ${kb[*]} kB"
}
