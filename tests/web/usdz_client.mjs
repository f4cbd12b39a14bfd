// node usdz_client.mjs DIR [SCREENSHOTS]: opens the USDZ of every hand-made pot of DIR with three.js in Debian's Chromium,
// and compares what arrived with what was thrown. Writes a screenshot a pot, to be looked at beside the GLB's.
import { expect } from './browser.mjs';
import { checkInBrowser, SIZE_TOLERANCE_M } from './in_browser.mjs';

function check(found, pot) {
    expect(!found.error, `the loader said: ${found.error}`);
    const radius = pot.diameter_m / 2;
    for (const [axis, low, high] of [[0, -radius, radius], [1, 0, pot.height_m], [2, -radius, radius]]) {
        expect(Math.abs(found.min[axis] - low) <= SIZE_TOLERANCE_M && Math.abs(found.max[axis] - high) <= SIZE_TOLERANCE_M,
            `expected axis ${axis} from ${low} to ${high} m, found ${found.min[axis]} to ${found.max[axis]}`);
    }
    expect(found.meshes === 1, `expected one mesh, found ${found.meshes}`);
    expect(found.triangles === pot.triangles, `expected ${pot.triangles} triangles, found ${found.triangles}`);
    for (const map of ['map', 'normalMap', 'roughnessMap', 'aoMap'])
        expect(found.material.maps[map] === Boolean(pot.dressed), `${map}: expected ${Boolean(pot.dressed)}`);
    expect(found.coverage > 0.03 && found.coverage < 0.6 && found.luminance > 40, 'expected a pot in the light');
    return `${found.triangles} triangles, ${(100 * found.coverage).toFixed(1)} % covered, luminance ${found.luminance.toFixed(0)}`;
}

await checkInBrowser({ address: 'index.html?usdz&pot=', suffix: '-usdz', check });
