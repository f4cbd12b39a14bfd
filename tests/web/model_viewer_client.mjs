// node model_viewer_client.mjs DIR [SCREENSHOTS]: opens the hand-made pots of DIR in Google's model-viewer, the element
// that most museums' pages show 3D with, and compares what arrived with what was thrown. Writes a screenshot a pot.
import { expect } from './browser.mjs';
import { checkInBrowser, SIZE_TOLERANCE_M } from './in_browser.mjs';

function compare(found, pot) {
    expect(!found.error, `the element said: ${found.error}`);
    const size = [pot.diameter_m, pot.height_m, pot.diameter_m];
    expect(size.every((side, axis) => Math.abs(side - found.size[axis]) <= SIZE_TOLERANCE_M),
        `expected ${size} m, found ${found.size}`);
    expect(found.materials.length === 1, `expected one material, found ${found.materials.length}`);
    const [material] = found.materials;
    expect(material.colour === Boolean(pot.dressed) && material.normal === Boolean(pot.dressed),
        `expected ${pot.dressed ? 'pictures' : 'none'}, found ${JSON.stringify(material)}`);
    return `${found.size.map((side) => (1000 * side).toFixed(2)).join(' x ')} mm`;
}

await checkInBrowser({ address: 'model-viewer.html?pot=', suffix: '-model-viewer', check: compare });
