# A bare Debian in a folder, and functions to run commands in it. Sourced, never run, in a private mount
# namespace; `root` is its folder, `cache` keeps downloads between runs, `suite` is the machine's unless it is set.

fail() { printf '%s\n' "$*"; exit 1; }
machine_suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
[ -n "$machine_suite" ] || fail "expected VERSION_CODENAME in /etc/os-release, found none"
suite=${suite:-$machine_suite}

say() { printf '\n== %s (%d s)\n' "$*" "$SECONDS"; }
# show COMMAND...: runs a command and prints it with its output.
show() {
    printf '# %s\n' "$*"
    "$@"
}

# The smallest root for apt, made once from the machine's package sources.
unpack_bare_debian() {
    if [ ! -s "$cache/$suite.tar" ]; then
        mkdir -p "$cache"
        sed "s/\b$machine_suite\b/$suite/g" "${ONGGI_DEBIAN_SOURCES:-/etc/apt/sources.list.d/debian.sources}" >"$cache/debian.sources"
        mmdebstrap --variant=minbase --include=ca-certificates "$suite" "$cache/$suite.part.tar" "$cache/debian.sources" \
            >"$cache/mmdebstrap.log" 2>&1 || { cat "$cache/mmdebstrap.log"; fail "expected a bare Debian $suite, made none"; }
        mv "$cache/$suite.part.tar" "$cache/$suite.tar"
    fi
    mkdir -p "$root"
    tar -xf "$cache/$suite.tar" -C "$root"
    # Where a machine has it, by which the root makes roots of its own.
    mv "$root"/etc/apt/sources.list.d/*.sources "$root/etc/apt/sources.list.d/debian.sources"
}

# File systems that the kernel and systemd would mount. None of the machine's devices.
mount_machine() {
    local node
    mount --bind "$root" "$root"
    mount -t proc proc "$root/proc"
    mount -t sysfs -o ro sysfs "$root/sys"
    mount -t tmpfs tmpfs "$root/run"
    mount -t tmpfs -o mode=1777 tmpfs "$root/tmp"
    mount -t tmpfs tmpfs "$root/dev"
    mkdir "$root/dev/pts" "$root/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"
    mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
    ln -s pts/ptmx "$root/dev/ptmx"
    ln -s /proc/self/fd "$root/dev/fd"
    for node in null zero full random urandom tty; do
        : >"$root/dev/$node"
        mount --bind "/dev/$node" "$root/dev/$node"
    done
    mkdir -p "$cache/archives/partial" "$cache/lists/partial"
    mount --bind "$cache/archives" "$root/var/cache/apt/archives"
    mount --bind "$cache/lists" "$root/var/lib/apt/lists"
}

# in_root COMMAND...; `(exec "${into_root[@]}" COMMAND...) &` for a process that will be ended by its id.
into_root=(chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin TZ=UTC LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive)
in_root() { "${into_root[@]}" "$@"; }
# Runs a command like the service: user, limits and environment from the installed unit. A container may
# refuse the limits.
as_service() {
    local unit=$root/usr/lib/systemd/system/onggi-kiosk.service environment limits
    read -ra environment < <(sed -n 's/^Environment=//p' "$unit")
    limits=(prlimit --rtprio="$(sed -n 's/^LimitRTPRIO=//p' "$unit")" --memlock=unlimited)
    "${limits[@]}" true 2>/dev/null || limits=()
    exec "${limits[@]}" chroot --userspec="$(sed -n 's/^User=//p' "$unit")" "$root" \
        env -i -C /var/lib/onggi PATH=/usr/bin:/bin TZ=UTC "${environment[@]}" "$@"
}
