#!/usr/bin/env bash
# Package: mediabunny 1.61.0 (npm).
# Behaviour: of an MP4's edit list it applies where the edit begins and not how long it lasts. Of a film of two seconds,
# an edit of the second half plays from -1 to 1 s as wanted; an edit of the first half plays both, and the duration is
# two seconds, without a warning.
# Expected: one second each: an edit is a start and a duration in one record (ISO/IEC 14496-12, 8.6.6), and what lies
# outside is not presented.
# Why it matters: phones trim a film by its edit list alone; a converter or player built on this shows a visitor what
# was cut off the end. Cut the samples themselves.
# Seen:
#   no edit: 2 s; second half: 1 s, starts at -1 s; first half: 2 s, starts at 0 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --prefix . --silent --ignore-scripts --no-audit --no-fund mediabunny@1.61.0
cat >cut.mjs <<'CODE'
import { ALL_FORMATS, BufferSource, BufferTarget, EncodedPacket, EncodedVideoPacketSource, Input, Mp4OutputFormat, Output }
    from 'mediabunny';
// Twenty key pictures of a tenth of a second; the boxes stand after them, so that they may grow.
const output = new Output({ format: new Mp4OutputFormat({ fastStart: false }), target: new BufferTarget() });
const source = new EncodedVideoPacketSource('vp9');
output.addVideoTrack(source, { frameRate: 10 });
await output.start();
const decoderConfig = { codec: 'vp09.00.10.08', codedWidth: 64, codedHeight: 64 };
for (let i = 0; i < 20; ++i)
    await source.add(new EncodedPacket(new Uint8Array([0x82, 0x49, 0x83, 0x42, 0, i]), 'key', i / 10, 0.1), { decoderConfig });
await output.finalize();
const film = Buffer.from(output.target.buffer);
const boxAt = (type) => film.lastIndexOf(type) - 4;
const ticksPerSecond = (type) => film.readUInt32BE(boxAt(type) + 20);
// The film with one edit: a second from startSeconds on.
function cut(startSeconds) {
    const edit = Buffer.alloc(36);
    edit.writeUInt32BE(36, 0);
    edit.write('edts', 4);
    edit.writeUInt32BE(28, 8);
    edit.write('elst', 12);
    edit.writeUInt32BE(1, 20);
    edit.writeUInt32BE(ticksPerSecond('mvhd'), 24);
    edit.writeInt32BE(startSeconds * ticksPerSecond('mdhd'), 28);
    edit.writeUInt32BE(0x10000, 32);
    const after = boxAt('tkhd') + film.readUInt32BE(boxAt('tkhd'));
    const whole = Buffer.concat([film.subarray(0, after), edit, film.subarray(after)]);
    for (const type of ['moov', 'trak']) whole.writeUInt32BE(film.readUInt32BE(boxAt(type)) + 36, boxAt(type));
    return whole;
}
async function told(file) {
    const track = await new Input({ source: new BufferSource(file), formats: ALL_FORMATS }).getPrimaryVideoTrack();
    return [await track.computeDuration(), await track.getFirstTimestamp()];
}
const [[whole], [second, secondStart], [first, firstStart]] =
    await Promise.all([told(film), told(cut(1)), told(cut(0))]);
console.log(`no edit: ${whole} s; second half: ${second} s, starts at ${secondStart} s; ` +
            `first half: ${first} s, starts at ${firstStart} s`);
CODE
saw=$(node cut.mjs)
echo "saw: $saw"
[ "$saw" = "no edit: 2 s; second half: 1 s, starts at -1 s; first half: 2 s, starts at 0 s" ]
