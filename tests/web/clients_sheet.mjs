// node clients_sheet.mjs MAKE_OUTBOX FOLDER: five pots under five glazes as the kiosk keeps them, and one that was drawn on, each by
// three.js, model-viewer, Blender (Cycles) and f3d beside the kiosk's own picture, on one sheet FOLDER/sheet.png.
// By hand, for eyes: `apt install blender python3-numpy f3d xvfb`; some minutes.
import { execFile } from 'node:child_process';
import { mkdir, copyFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { launch, SLOWNESS } from './browser.mjs';
import { serve } from './server.mjs';

const run = promisify(execFile);
const here = path.dirname(fileURLToPath(import.meta.url));
const POTS = [['vase', 'celadon'], ['moon_jar', 'porcelain'], ['bowl', 'buncheong'], ['cylinder', 'iron'], ['moon_jar_half', 'ash'],
    ['moon_jar', 'celadon', '--decorated']].map(([thrown, glaze, ...how]) => ({ pot: [thrown, ...how].join(''), thrown, glaze, how }));
const CLIENTS = ['kiosk', 'three', 'model-viewer', 'blender', 'f3d'];
const SIDE_PX = 480;

const [makeOutbox, folder] = process.argv.slice(2);
if (!folder) {
    console.error('expected: node clients_sheet.mjs MAKE_OUTBOX FOLDER');
    process.exit(2);
}
await mkdir(folder, { recursive: true });
const picture = (pot, client) => path.join(folder, `${pot}-${client}.png`);

for (const { pot, thrown, glaze, how } of POTS) {
    const session = path.join(here, `../../assets/demonstrations/${thrown}.onggi`);
    const made = path.join(folder, 'made', pot);
    await run(makeOutbox, [session, made, '--glaze', glaze, ...how]);
    await copyFile(path.join(made, 'pot.glb'), path.join(folder, `${pot}.glb`));
    await copyFile(path.join(made, 'pot.png'), picture(pot, 'kiosk'));
    await run('blender', ['--background', '--factory-startup', '--python-exit-code', '1', '--python', path.join(here, 'blender_picture.py'), '--',
        path.join(folder, `${pot}.glb`), picture(pot, 'blender'), String(SIDE_PX)]);
    await run('bash', [path.join(here, '../window/with_display.sh'), path.join(folder, 'display'), 'f3d', path.join(folder, `${pot}.glb`), `--output=${picture(pot, 'f3d')}`,
        `--resolution=${SIDE_PX},${SIDE_PX}`, '--camera-elevation-angle=16', '--tone-mapping', '--ssao',
        '--bg-color=0.125,0.14,0.157']);
}

const server = await serve(folder);
const browser = await launch();
try {
    const page = await browser.newPage({ viewport: { width: SIDE_PX, height: SIDE_PX } });
    for (const { pot } of POTS) {
        for (const [client, address] of [['three', 'index.html?room=1&'], ['model-viewer', 'model-viewer.html?']]) {
            await page.goto(`${server.origin}/${address}pot=${pot}`);
            await page.waitForFunction('window.found !== undefined', null, { timeout: 60_000 * SLOWNESS });
            await page.waitForTimeout(1500);  // model-viewer fades in
            await page.screenshot({ path: picture(pot, client) });
        }
    }
    const cells = POTS.map(({ pot, glaze }) => `<tr><th>${pot}<br>${glaze}</th>${CLIENTS.map((client) =>
        `<td><img src="${pot}-${client}.png" width="240" height="240"></td>`).join('')}</tr>`).join('');
    const sheet = path.join(folder, 'sheet.html');
    await writeFile(sheet, `<!DOCTYPE html><style>body { margin: 8px; background: #202428; color: #eee; font: 16px sans-serif; }</style>
<table><tr><th></th>${CLIENTS.map((client) => `<th>${client}</th>`).join('')}</tr>${cells}</table>`);
    await page.setViewportSize({ width: 1400, height: 1580 });
    await page.goto(pathToFileURL(path.resolve(sheet)).href);
    await page.screenshot({ path: path.join(folder, 'sheet.png') });
} finally {
    await browser.close();
    await server.close();
}
console.log(path.join(folder, 'sheet.png'));
