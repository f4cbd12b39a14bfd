# Takes a kept pot home by phone and puts it on the wall of the day. Sourced by visitor.sh, never run. The
# kiosk's own server listens here, at a port chosen by the system. Also needs zbarimg, which reads the code
# from the screen, and curl.
mkdir -p outbox
"$onggi" share --outbox outbox --listen 127.0.0.1 --port 0 >share.log 2>&1 &
phone_server=$!
trap 'kill $kiosk $server $phone_server 2>/dev/null || true' EXIT
phones=
is_served() { phones=$(sed -n 's/.*, port \([0-9]*\).*/\1/p' share.log) && [ -n "$phones" ]; }
kiosk=$phone_server wait_for "a server for phones" is_served
cat >>kiosk.toml <<TOML
wall = true
[sharing]
listen = "127.0.0.1"
port = $phones
outbox = "outbox"
TOML

address=
reads_the_code() {
    address=$(zbarimg -q --raw xwd:Xvfb_screen0 2>/dev/null | grep -m 1 '^http') && [ -n "$address" ]
}
# The code on the screen leads to the page, in the visitor's language, and to the gallery's files.
take_it_home() {
    wait_for "a code that a phone can read" reads_the_code
    address=${address%/}
    local code=${address##*/} file
    [[ $code =~ ^[0-9A-Z]{8}$ && -d outbox/$code ]] || fail "expected the code of a pot in the outbox, found '$address'"
    curl -sSf --max-time 20 "$address/" >page.html ||
        fail "expected a page at $address, found none"
    grep -q "<html lang=\"$language\"" page.html || fail "expected a page in '$language', found $(head -c 200 page.html)"
    for file in pot.glb pot.stl pot.3mf; do
        curl -sSf --max-time 20 "$address/$file" | cmp - "$pot/$file" ||
            fail "expected the gallery's $file at $address, found another"
    done
    printf 'taken home: %s bytes of page, %s of pot.glb\n' "$(wc -c <page.html)" "$(wc -c <"$pot/pot.glb")"
}
# Puts the pot up, takes it down, and puts it up again.
hangs() { grep -qs "\"$(basename "$(dirname "$pot")")/$(basename "$pot")\"" gallery/state/wall.json; }
hangs_not() { ! hangs; }
hang_it_on_the_wall() {
    press keep-wall on-wall; wait_for "the pot on the wall" hangs
    press keep-wall on-wall; wait_for "the wall without the pot" hangs_not
    press keep-wall on-wall; wait_for "the pot on the wall again" hangs
    on_screen keep
}
# A late film is added to the page afterwards. A busy test machine leaves no time to a process of idle
# priority, so the film process is raised now that the visit is over.
has_a_film() { curl -sSf --max-time 20 "$address/" | grep -q 'href="film.webp"'; }
look_at_the_film() {
    local maker
    for maker in $(pgrep --parent "$kiosk"); do
        chrt --all-tasks --other --pid 0 "$maker" || true
    done
    wait_for "film on the page" has_a_film
    curl -sSf --max-time 20 "$address/film.webp" -o film.webp
    [ "$(head -c 34 film.webp | tail -c 4)" = ANIM ] || fail "expected a film that moves, found $(file -b film.webp)"
}
# The wall is shown to its maker first: the boards are darker than the room, and the wheel is not visible.
look_at_the_wall() {
    pause 10
    on_screen attract
}
