#!/usr/bin/env bash
# All visitors, one after the other: visits.sh ONGGI PROGRAMS FOLDER. Each device in each language at 16:9,
# and the mouse in each language at the other shapes; the failed visit by SpaceMouse; with ImageMagick also a
# sheet of each visit's screens. A minute or two each; exit code 1 if one did not keep a pot.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
onggi=$(realpath "$1")
programs=$(realpath "$2")
mkdir -p "$3"
folder=$(realpath "$3")
status=0
# visit HAND LANGUAGE WxH [SCRIPT]
visit() {
    local name=$1-$2-$3 script=${4:-visit}
    [ "$script" = visit ] || name=$script-$name
    if bash "$here/$script.sh" "$onggi" "$programs" "$folder/$name" "$1" "$2" "$3"; then
        command -v montage >/dev/null &&
            montage "$folder/$name"/[0-9]*.png -tile 4x -geometry 480x+4+4 "$folder/$name.png" || true
    else
        printf 'FAILED: %s\n' "$name"
        status=1
    fi
}
for language in ko en ar; do
    for hand in mouse touch keys switch gamepad; do
        visit "$hand" "$language" 1280x720
    done
    for size in 720x1280 1024x768 1920x1080; do
        visit mouse "$language" "$size"
    done
    visit spacemouse "$language" 1280x720 failed_visit
done
exit "$status"
