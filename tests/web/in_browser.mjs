// Opens each hand-made pot of a folder in a page of Debian's Chromium: what the clients' checks share.
import { mkdir } from 'node:fs/promises';
import path from 'node:path';
import { expect, launch, SLOWNESS, watch } from './browser.mjs';
import { checkAll, listPots } from './pots.mjs';
import { serve } from './server.mjs';

// Long on a busy machine: the runner ends a test that hangs, and does not count the time in which it waits for a core.
const PAGE_TIMEOUT_MS = 600_000 * SLOWNESS;
/** How far a size that arrives may be off: a tenth of a millimetre. */
export const SIZE_TOLERANCE_M = 0.0001;

/**
 * `node SCRIPT DIR [SCREENSHOTS]`: loads ADDRESS + the pot's name for every hand-made pot of DIR, waits for what the page
 * leaves in window.found, hands it to `check(found, pot)`, which throws or gives a line, and writes a screenshot a pot.
 * Fails on any console error, failed request, or request to another host.
 */
export async function checkInBrowser({ address, suffix = '', check }) {
    const [folder, screenshots] = process.argv.slice(2);
    if (!folder) {
        console.error(`expected: node ${path.basename(process.argv[1])} DIR [SCREENSHOTS]`);
        process.exit(2);
    }
    if (screenshots) await mkdir(screenshots, { recursive: true });
    const pots = (await listPots(folder)).filter((pot) => pot.hand_made);
    const server = await serve(folder);
    const browser = await launch();
    try {
        console.log(`Chromium ${browser.version()}`);
        await checkAll(pots, async (pot) => {
            const page = await browser.newPage({ viewport: { width: 480, height: 480 } });
            page.setDefaultTimeout(PAGE_TIMEOUT_MS);
            const complaints = watch(page, server.origin);
            try {
                await page.goto(`${server.origin}/${address}${pot.name}`);
                await page.waitForFunction('window.found !== undefined');
                const found = await page.evaluate('window.found');
                if (screenshots) await page.screenshot({ path: path.join(screenshots, `${pot.name}${suffix}.png`) });
                const line = check(found, pot);
                expect(complaints.length === 0, complaints.join('; '));
                return line;
            } finally {
                await page.close();
            }
        });
    } finally {
        await browser.close();
        await server.close();
    }
}
