// node clients_sheet.mjs MAKE_OUTBOX FOLDER: ten pots as the kiosk keeps them (dented, lopsided, collapsed and drawn on among
// them), each in the kiosk's own picture, on the phone's page, and by three.js, Babylon.js, PlayCanvas, model-viewer, Blender
// (Cycles) and f3d, on one sheet FOLDER/sheet.png, with the bytes of each GLB. By hand, for eyes:
// `npm ci`, `apt install --no-install-recommends blender python3-numpy f3d xvfb`; some minutes.
import { execFile } from 'node:child_process';
import { mkdir, copyFile, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { expect, launch, SLOWNESS, watch } from './browser.mjs';
import { makeOutbox, serveByPython } from './phone_programs.mjs';
import { serve } from './server.mjs';

const run = promisify(execFile);
const here = path.dirname(fileURLToPath(import.meta.url));
const POTS = [['vase', 'celadon'], ['moon_jar', 'porcelain'], ['bowl', 'buncheong'], ['cylinder', 'iron'], ['moon_jar_half', 'ash'],
    ['collapse', 'bare'], ['studio_dented', 'celadon'], ['studio_lopsided', 'ash'], ['moon_jar', 'celadon', '--decorated'],
    ['vase', 'porcelain', '--banded']].map(([thrown, glaze, ...how]) => ({ pot: [thrown, ...how].join(''), thrown, glaze, how }));
const IN_BROWSER = { three: 'index.html?room=1&', babylon: 'babylon.html?', playcanvas: 'playcanvas.html?', 'model-viewer': 'model-viewer.html?' };
const CLIENTS = ['kiosk', 'page', ...Object.keys(IN_BROWSER), 'blender', 'f3d'];
const SIDE_PX = 480;

const [makeProgram, folder] = process.argv.slice(2);
if (!folder) {
    console.error('expected: node clients_sheet.mjs MAKE_OUTBOX FOLDER');
    process.exit(2);
}
await mkdir(folder, { recursive: true });
const picture = (pot, client) => path.join(folder, `${pot}-${client}.png`);

for (const made of POTS) {
    const { pot, thrown, glaze, how } = made;
    const session = thrown.startsWith('studio_') ? thrown : path.join(here, `../../assets/demonstrations/${thrown}.onggi`);
    const place = path.join(folder, 'made', pot);
    made.code = await makeOutbox(makeProgram, session, place, ['--glaze', glaze, ...how]);
    await copyFile(path.join(place, 'pot.glb'), path.join(folder, `${pot}.glb`));
    await copyFile(path.join(place, 'pot.png'), picture(pot, 'kiosk'));
    await run('blender', ['--background', '--factory-startup', '--python-exit-code', '1', '--python', path.join(here, 'blender_picture.py'), '--',
        path.join(folder, `${pot}.glb`), picture(pot, 'blender'), String(SIDE_PX)]);
    await run('bash', [path.join(here, '../window/with_display.sh'), path.join(folder, 'display'), 'f3d', path.join(folder, `${pot}.glb`), `--output=${picture(pot, 'f3d')}`,
        `--resolution=${SIDE_PX},${SIDE_PX}`, '--camera-elevation-angle=16', '--tone-mapping', '--ssao',
        '--bg-color=0.125,0.14,0.157']);
}

/** As a phone shows it that wants less motion: the pot as it first stands. */
async function pageOf(browser, origin, { pot, code }) {
    const page = await browser.newPage({ viewport: { width: SIDE_PX, height: 2 * SIDE_PX }, reducedMotion: 'reduce', bypassCSP: true });
    await page.goto(`${origin}/${pot}/box/${code}/`);
    await page.waitForSelector('.drawn', { timeout: 60_000 * SLOWNESS });
    await page.addStyleTag({ content: `.stage { width: ${SIDE_PX}px !important; height: ${SIDE_PX}px !important; max-height: none !important; }` });
    await page.evaluate(() => dispatchEvent(new Event('resize')));
    await page.waitForTimeout(300 * SLOWNESS);
    await page.locator('#stage').screenshot({ path: picture(pot, 'page') });
    await page.close();
}

const server = await serve(folder);
const phones = await serveByPython(path.join(folder, 'made'));
const browser = await launch();
try {
    const page = await browser.newPage({ viewport: { width: SIDE_PX, height: SIDE_PX } });
    const complaints = watch(page, server.origin);
    for (const made of POTS) {
        await pageOf(browser, phones.origin, made);
        for (const [client, address] of Object.entries(IN_BROWSER)) {
            await page.goto(`${server.origin}/${address}pot=${made.pot}`);
            await page.waitForFunction('window.found !== undefined', null, { timeout: 60_000 * SLOWNESS });
            const { error } = await page.evaluate('window.found');
            expect(!error && complaints.length === 0, `${client}, ${made.pot}: ${error ?? complaints.join('; ')}`);
            await page.waitForTimeout(1500);  // model-viewer fades in
            await page.screenshot({ path: picture(made.pot, client) });
        }
        made.bytes = (await stat(path.join(folder, `${made.pot}.glb`))).size;
    }
    const cells = POTS.map(({ pot, glaze, bytes }) => `<tr><th>${pot}<br>${glaze}<br>${Math.round(bytes / 1000)} kB</th>${CLIENTS.map((client) =>
        `<td><img src="${pot}-${client}.png" width="240" height="240"></td>`).join('')}</tr>`).join('');
    const sheet = path.join(folder, 'sheet.html');
    await writeFile(sheet, `<!DOCTYPE html><style>body { margin: 8px; background: #202428; color: #eee; font: 16px sans-serif; }</style>
<table><tr><th></th>${CLIENTS.map((client) => `<th>${client}</th>`).join('')}</tr>${cells}</table>`);
    await page.setViewportSize({ width: 2140, height: 2560 });
    await page.goto(pathToFileURL(path.resolve(sheet)).href);
    await page.screenshot({ path: path.join(folder, 'sheet.png') });
} finally {
    await browser.close();
    await phones.stop();
    await server.close();
}
console.log(path.join(folder, 'sheet.png'));
