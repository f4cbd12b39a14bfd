# Whether a program holds more memory after each turn of the same things. Sourced, never run; whoever calls has put the
# process into `kiosk` and its words into kiosk.log, and has fail() of waiting.sh.

# What the program has allocated itself, in kB; pages of files are not in it, so that fonts and drivers do not decide.
# The least of a second: a thread may be at work that gives back what it takes.
own_memory_kb() {
    for _ in 1 2 3 4 5; do
        awk '$1 == "Anonymous:" { print $2 }' "/proc/$kiosk/smaps_rollup"
        sleep 0.2
    done | sort -n | head -1
}

# holds_no_more TURN...: does it until the memory after four turns in a row is the same, but for some pages. At first it
# rises and falls: caches fill, and the quality of the picture changes. A leak goes on, and what is given back just then
# cannot hide it for long.
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
