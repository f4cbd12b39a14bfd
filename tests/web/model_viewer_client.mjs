// node model_viewer_client.mjs DIR [SCREENSHOTS]: opens the hand-made pots of DIR in Google's model-viewer, the element
// that most museums' pages show 3D with, and compares what arrived with what was thrown. Writes a screenshot a pot.
import { mkdir } from 'node:fs/promises';
import path from 'node:path';
import { expect, launch, watch } from './browser.mjs';
import { checkAll, listPots } from './pots.mjs';
import { serve } from './server.mjs';

const PAGE_TIMEOUT_MS = 60_000;
const SIZE_TOLERANCE_M = 0.0001;  // a tenth of a millimetre

const [folder, screenshots] = process.argv.slice(2);
if (!folder) {
    console.error('expected: node model_viewer_client.mjs DIR [SCREENSHOTS]');
    process.exit(2);
}
if (screenshots) await mkdir(screenshots, { recursive: true });
const pots = (await listPots(folder)).filter((pot) => pot.hand_made);
const server = await serve(folder);
const browser = await launch();
try {
    await checkAll(pots, async (pot) => {
        const page = await browser.newPage({ viewport: { width: 480, height: 480 } });
        const complaints = watch(page, server.origin);
        try {
            await page.goto(`${server.origin}/model-viewer.html?pot=${pot.name}`);
            await page.waitForFunction('window.found !== undefined', null, { timeout: PAGE_TIMEOUT_MS });
            const found = await page.evaluate('window.found');
            expect(!found.error, `the element said: ${found.error}`);
            if (screenshots) await page.screenshot({ path: path.join(screenshots, `${pot.name}-model-viewer.png`) });
            const size = [pot.diameter_m, pot.height_m, pot.diameter_m];
            expect(size.every((side, axis) => Math.abs(side - found.size[axis]) <= SIZE_TOLERANCE_M),
                `expected ${size} m, found ${found.size}`);
            expect(found.materials.length === 1, `expected one material, found ${found.materials.length}`);
            const [material] = found.materials;
            expect(material.colour === Boolean(pot.dressed) && material.normal === Boolean(pot.dressed),
                `expected ${pot.dressed ? 'pictures' : 'none'}, found ${JSON.stringify(material)}`);
            expect(complaints.length === 0, complaints.join('; '));
            return `${found.size.map((side) => (1000 * side).toFixed(2)).join(' x ')} mm`;
        } finally {
            await page.close();
        }
    });
} finally {
    await browser.close();
    await server.close();
}
