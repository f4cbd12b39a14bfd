#!/usr/bin/env bash
# Validators of such files report nothing: lintian, man and groff, those of the desktop and of software
# centres, bash. lint.sh PACKAGES FOLDER
set -euo pipefail
packages=$1 folder=$2
for tool in lintian man groff desktop-file-validate appstreamcli; do
    command -v "$tool" >/dev/null || { echo "SKIPPED: no $tool"; exit 77; }
done
rm -rf "$folder"
mkdir -p "$folder"
lintian --fail-on error,warning "$packages"/onggi*.deb
# Lintian must find planted faults: a world-writable program and a missing copyright file.
dpkg-deb -R "$packages"/onggi_*.deb "$folder/wrong"
chmod 777 "$folder/wrong/usr/bin/onggi"
rm "$folder/wrong/usr/share/doc/onggi/copyright"
dpkg-deb --root-owner-group -b "$folder/wrong" "$folder/wrong.deb" >/dev/null
if lintian --fail-on error,warning "$folder/wrong.deb" >"$folder/wrong.txt" 2>&1; then
    echo "expected lintian to find the faults of $folder/wrong.deb"
    exit 1
fi
grep -q no-copyright-file "$folder/wrong.txt"

for package in "$packages"/onggi*.deb; do dpkg-deb -x "$package" "$folder/tree"; done
share=$folder/tree/usr/share
# silent WHAT COMMAND...: the command must print nothing and succeed.
silent() {
    local what=$1 said
    shift
    said=$("$@" 2>&1 >"$folder/out.txt") && [ -z "$said" ] || { printf 'expected silence about %s, found:\n%s\n' "$what" "$said"; exit 1; }
}
for page in man1/onggi.1 man5/kiosk.toml.5 man8/onggi-kiosk.8; do
    gzip -dc "$share/man/$page.gz" >"$folder/page"
    silent "$page" groff -ww -man -Tutf8 "$folder/page"
    silent "$page" env LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l "$folder/page"
done
printf '.TH\n.nonsense \\q\n' >"$folder/page"
[ -n "$(groff -ww -man -Tutf8 "$folder/page" 2>&1 >/dev/null)" ] || { echo "groff let nonsense pass"; exit 1; }
# Every setting and every option of the help is in the manual page.
while read -r key; do
    gzip -dc "$share/man/man5/kiosk.toml.5.gz" | grep -q "^.fB$key = " || { echo "expected $key in kiosk.toml(5)"; exit 1; }
done < <(sed -nE 's/^#?([a-z_]+) = .*/\1/p' "$share/onggi/kiosk-settings.toml")
gzip -dc "$share/man/man1/onggi.1.gz" | sed 's/\\-/-/g' >"$folder/onggi.1"
program=$folder/tree/usr/bin/onggi
for name in $("$program" --help | awk '/^Subcommands:/ { on = 1; next } on && NF { print $1 }'); do
    while read -r option; do
        grep -qF -e "$option" "$folder/onggi.1" || { echo "expected onggi $name $option in onggi(1)"; exit 1; }
    done < <("$program" "$name" --help | grep -oE '^  (-h,)?--[a-z-]+')
done

silent "the desktop file" desktop-file-validate "$share/applications/onggi.desktop"
appstreamcli validate --no-net "$share/metainfo/onggi.metainfo.xml"

# complete_words WORD...: bash's completions of the last word.
complete_words() {
    bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _onggi; echo "${COMPREPLY[*]}"' - \
        "$share/bash-completion/completions/onggi" "$@"
}
[ "$(complete_words onggi th)" = throw ] || { echo "expected bash to know the commands"; exit 1; }
[ "$(complete_words onggi throw --fired gl)" = glaze ] || { echo "expected bash to know the stages"; exit 1; }
[ "$(complete_words onggi gallery ex)" = export ] || { echo "expected bash to know the words of a command"; exit 1; }
[ "$(complete_words onggi film --qu)" = --quick ] || { echo "expected bash to know the options"; exit 1; }
echo "lintian, man, groff, desktop-file-validate, appstreamcli and bash have no complaint"
