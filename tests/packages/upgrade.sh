# Settings, pots and a visit across upgrades and removal of packages. Sourced by bare_debian.sh, never run.

# install_packages FILE...: installs with apt, which fetches dependencies.
install_packages() {
    show in_root apt-get -y install "${@#"$root"}" >"$folder/apt.log" 2>&1 || { tail -40 "$folder/apt.log"; fail "expected apt to install"; }
    grep -E 'newly installed|Need to get|additional disk space|^Fetched' "$folder/apt.log" || true
}
pots_sum() { (cd "$root/var/lib/onggi" && find gallery -path gallery/state -prune -o -type f -print0 | sort -z | xargs -0 sha256sum | sha256sum); }

# make_later PACKAGE INTO: repacks it with a later version and another default setting.
make_later() {
    local work
    work=$(mktemp -d -p "$folder")
    dpkg-deb -R "$1" "$work"
    sed -i -E '/^Version:/s/$/+later/; s/(onggi \(= [^)]*)\)/\1+later)/' "$work/DEBIAN/control"
    if [ -e "$work/usr/share/onggi/kiosk.toml" ]; then
        echo '# a later default' >>"$work/usr/share/onggi/kiosk.toml"
        (cd "$work" && find . -path ./DEBIAN -prune -o -type f -printf '%P\0' | sort -z | xargs -0 md5sum) >"$work/DEBIAN/md5sums"
    fi
    dpkg-deb --root-owner-group -b "$work" "$2" >/dev/null
}

upgrade_between_two_halves_of_a_visit() {
    local pots settings package
    mkdir -p "$root/tmp/later"
    for package in "$packages"/onggi*.deb; do make_later "$package" "$root/tmp/later/$(basename "$package")"; done
    TURNED=1 bash "$here/visit.sh" begin "$build" "$root" "$folder/first_half"
    pots=$(pots_sum)
    settings=$(sha256sum <"$root/etc/onggi/kiosk.toml")
    echo '# the museum'"'"'s own' >>"$root/etc/security/limits.d/70-onggi.conf"

    install_packages "$root"/tmp/later/onggi*.deb
    in_root dpkg-query -W -f '${Package} ${Version}\n' onggi onggi-kiosk
    [ "$(in_root dpkg-query -W -f '${Version}\n' onggi onggi-kiosk | grep -c 'later$')" = 2 ] || fail "expected the later version"
    grep -q 'a later default' "$root/usr/share/onggi/kiosk.toml" || fail "expected the later package's files"
    [ "$settings" = "$(sha256sum <"$root/etc/onggi/kiosk.toml")" ] || fail "expected the museum's settings to stay"
    grep -q 'museum' "$root/etc/security/limits.d/70-onggi.conf" || fail "expected the museum's limits to stay"
    in_root systemctl is-enabled onggi-kiosk >/dev/null || fail "expected the wheel to start with the machine"
    [ "$pots" = "$(pots_sum)" ] || fail "expected the pots to stay"
    echo "settings, limits and pots are as they were"
    TURNED=1 bash "$here/visit.sh" resume "$build" "$root" "$folder/second_half"
    # A disabled service stays disabled.
    in_root systemctl disable -q onggi-kiosk
    in_root dpkg -i "/tmp/later/$(basename "$root"/tmp/later/onggi-kiosk_*.deb)" >"$folder/again.log" 2>&1
    [ "$(in_root systemctl is-enabled onggi-kiosk || true)" = disabled ] || fail "expected a disabled wheel to stay disabled"
}

purge_but_for_pots() {
    local pots left
    pots=$(pots_sum)
    in_root sh -c 'echo pot >/var/lib/onggi-outbox/pot'
    show in_root apt-get -y purge onggi-kiosk onggi >"$folder/purge.log" 2>&1 || { cat "$folder/purge.log"; fail "expected apt to purge"; }
    [ "$pots" = "$(pots_sum)" ] || fail "expected the pots to stay"
    show in_root find /var/lib/onggi -path '*/pot-*' -printf '%M %u %s %p\n'
    # Only the pots, their owner, and files of systemd and dpkg may be left.
    left=$(in_root find / -xdev -iname '*onggi*' -not -path '/tmp/*' -not -path '/var/lib/onggi*' -not -path '/proc/*' \
        -not -path '/var/cache/apt/archives/*')
    [ -z "$left" ] || fail "expected nothing left, found: $left"
    [ ! -e "$root/var/lib/onggi-outbox" ] || fail "expected the phones' copies to be gone"
    ! in_root sh -c 'command -v onggi' || fail "expected no program"
}
