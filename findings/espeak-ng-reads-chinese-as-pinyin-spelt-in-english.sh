#!/usr/bin/env bash
# Package: espeak-ng, libespeak-ng1, espeak-ng-data 1.51+dfsg-10+deb12u2 (Debian 12).
# Behaviour: the voice that "cmn" and "zh" select speaks Chinese characters as their pinyin read by English rules, with the
# tone as an English number: ni hao becomes "neye five five tree, hey-oh five". The voice cmn-latn-pinyin reads
# the same characters in Mandarin with tones. All three end with exit code 0 and without a word.
# Expected: the language's own code selects a voice that reads its script; a suffix "latn" is for texts in Latin letters.
# Why it matters: a kiosk that takes the voice by the language of its texts speaks Chinese that no one understands, and no
# test of "there is a sound" notices. Ask for cmn-latn-pinyin.
# Seen:
#   cmn: English phonemes; zh: English phonemes; cmn-latn-pinyin: none
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
version=1.51+dfsg-10+deb12u2
apt-get -qq -o APT::Sandbox::User=root download "espeak-ng=$version" "libespeak-ng1=$version" "espeak-ng-data=$version" \
    libpcaudio0=1.2-2 libsonic0=0.2.0-12
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=usr/lib/x86_64-linux-gnu
# With -x it prints phonemes, each change of language in brackets.
voice() {
    LD_LIBRARY_PATH=$libraries usr/bin/espeak-ng --path=$libraries -q -x -v "$1" '你好' >said.txt
    if grep -q '(en)' said.txt; then echo "English phonemes"; else echo none; fi
}
saw="cmn: $(voice cmn); zh: $(voice zh); cmn-latn-pinyin: $(voice cmn-latn-pinyin)"
echo "saw: $saw"
[ "$saw" = "cmn: English phonemes; zh: English phonemes; cmn-latn-pinyin: none" ]
