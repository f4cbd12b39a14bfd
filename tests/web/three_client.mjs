// node three_client.mjs DIR [SCREENSHOTS]: opens every hand-made pot of DIR with three.js in Debian's Chromium, as a
// visitor's phone would, and compares what arrived with what was thrown. Writes a screenshot a pot.
import { expect } from './browser.mjs';
import { checkInBrowser, SIZE_TOLERANCE_M } from './in_browser.mjs';

const CLAY = [0.36, 0.29, 0.215];

const near = (a, b, tolerance) => Math.abs(a - b) <= tolerance;

/** Everything that arrived, against the list that make_pots wrote. */
function compare(found, pot) {
    expect(!found.error, `the loader said: ${found.error}`);
    const radius = pot.diameter_m / 2;
    const [min, max] = [[-radius, 0, -radius], [radius, pot.height_m, radius]];
    for (let axis = 0; axis < 3; axis += 1) {
        expect(near(found.min[axis], min[axis], SIZE_TOLERANCE_M) && near(found.max[axis], max[axis], SIZE_TOLERANCE_M),
            `expected a box from ${min} to ${max} m, found ${found.min} to ${found.max}`);
    }
    expect(found.min[1] === 0, `expected the base at y = 0, found ${found.min[1]}`);
    expect(found.meshes === 1 && found.identity, 'expected one mesh at the origin');
    expect(found.triangles === pot.triangles, `expected ${pot.triangles} triangles, found ${found.triangles}`);
    const { material } = found;
    if (pot.dressed) {
        expect(material.type === 'MeshPhysicalMaterial' || material.type === 'MeshStandardMaterial', `found ${material.type}`);
        for (const map of ['map', 'normalMap', 'roughnessMap', 'aoMap']) expect(material.maps[map], `expected a ${map}`);
        expect(material.tangents, 'expected tangents beside the picture of normals');
        expect(found.coverage > 0.03 && found.coverage < 0.6 && found.luminance > 40, 'expected a pot in the light');
        return;
    }
    expect(material.type === 'MeshStandardMaterial' && material.side === 'front' && !material.textured,
        `expected a plain one-sided material, found ${JSON.stringify(material)}`);
    expect(CLAY.every((channel, i) => near(material.colour[i], channel, 1e-6)), `expected ${CLAY}, found ${material.colour}`);
    expect(near(material.roughness, 0.62, 1e-6) && material.metalness === 0, 'expected rough clay, not metal');
    expect(/^Onggi \d+\.\d+\.\d+$/.test(found.generator), `expected the program's name, found ${found.generator}`);
    expect(near(found.extras.height_mm, pot.height_m * 1000, 1e-9), 'expected the height among the extras');
    expect(near(found.extras.volume_mm3 * 1e-9, pot.volume_m3, 1e-9 * pot.volume_m3), 'expected the volume among them');
    expect(found.coverage > 0.03 && found.coverage < 0.6, `expected a pot in the picture, found ${found.coverage} covered`);
    expect(found.luminance > 60, `expected the lamp's side to face us, found a luminance of ${found.luminance}`);
}

function check(found, pot) {
    compare(found, pot);
    const size = found.max.map((high, axis) => (1000 * (high - found.min[axis])).toFixed(2));
    return `${size.join(' x ')} mm, ${found.triangles} triangles, ` +
        `${(100 * found.coverage).toFixed(1)} % covered, luminance ${found.luminance.toFixed(0)}`;
}

await checkInBrowser({ address: 'index.html?pot=', check });
