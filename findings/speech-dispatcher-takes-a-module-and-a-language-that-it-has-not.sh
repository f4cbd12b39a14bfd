#!/usr/bin/env bash
# Package: speech-dispatcher 0.11.4-2 (Debian 12) with its dummy module alone.
# Behaviour: the server answers 2xx OK where a client chooses an output module, a language or a voice that it has not, and
# GET gives the wanted names back as if they were in use; the language is put into lower case, de_DE to de_de.
# Expected: an error (4xx), as for a rate of 200 (409) or a priority that is unknown (408).
# Why it matters: a kiosk that asks for Korean learns from no answer that nobody will speak it, and a comparison of the
# language with its own name fails. Ask LIST OUTPUT_MODULES and LIST SYNTHESIS_VOICES, and compare before choosing.
# Seen:
#   module 216, none; language 201, xx; de_DE: de_de; voice 209; rate of 200: 409
set -euo pipefail
folder=$(mktemp -d)
server=
trap '[ -z "$server" ] || kill "$server" 2>/dev/null || true; rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download speech-dispatcher=0.11.4-2 speech-dispatcher-audio-plugins=0.11.4-2 libspeechd2=0.11.4-2 \
    libdotconf0=1.3-0.3 libltdl7=2.4.7-7~deb12u1 libao4=1.2.2+20180113-1.1 libao-common=1.2.2+20180113-1.1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
mkdir -p settings/modules settings/clients log
printf '%s\n' 'LogLevel 1' 'AudioOutputMethod "libao"' 'AddModule "dummy" "sd_dummy" ""' 'DefaultModule dummy' >settings/speechd.conf
HOME=$PWD XDG_RUNTIME_DIR=$PWD LD_LIBRARY_PATH=$libraries SPEECHD_PLUGIN_DIR=$libraries/speech-dispatcher \
    usr/bin/speech-dispatcher -s -t 0 -c unix_socket -S "$PWD/socket" -P "$PWD/pid" -C "$PWD/settings" \
    -m "$PWD/usr/lib/speech-dispatcher-modules" -L "$PWD/log" >said 2>&1 &
server=$!
for ((i = 0; i < 100; ++i)); do [ ! -S socket ] || break; sleep 0.1; done
cat >ask.py <<'CODE'
import socket

server = socket.socket(socket.AF_UNIX)
server.connect('socket')
answers = server.makefile('rb')

def ask(line):
    """The code and the text of the answer's first line; reads to its last."""
    server.sendall(line.encode() + b'\r\n')
    lines = [answers.readline().decode()]
    while lines[-1][3] == '-':
        lines.append(answers.readline().decode())
    return lines[-1][:3], lines[0][4:].strip()

ask('SET self CLIENT_NAME potter:kiosk:main')
module, _ = ask('SET self OUTPUT_MODULE none')
_, chosen = ask('GET OUTPUT_MODULE')
language, _ = ask('SET self LANGUAGE xx')
_, spoken = ask('GET LANGUAGE')
ask('SET self LANGUAGE de_DE')
_, german = ask('GET LANGUAGE')
voice, _ = ask('SET self SYNTHESIS_VOICE nobody')
rate, _ = ask('SET self RATE 200')
print(f'module {module}, {chosen}; language {language}, {spoken}; de_DE: {german}; voice {voice}; rate of 200: {rate}')
CODE
saw=$(python3 ask.py)
echo "saw: $saw"
[ "$saw" = "module 216, none; language 201, xx; de_DE: de_de; voice 209; rate of 200: 409" ]
