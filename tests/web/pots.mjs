// The pots that make_pots wrote, and what must be found in them. Shared by both checks.
import { readFile } from 'node:fs/promises';
import path from 'node:path';

/** @returns {Promise<{name: string, file: string, height_m: number, diameter_m: number, triangles: number,
 *   hand_made: boolean}[]>} as listed in DIR/pots.json; throws if there are none */
export async function listPots(folder) {
    const pots = JSON.parse(await readFile(path.join(folder, 'pots.json'), 'utf8'));
    if (pots.length === 0) throw new Error(`${folder}: expected pots, found none`);
    return pots.map((pot) => ({ ...pot, file: path.join(folder, `${pot.name}.glb`) }));
}

/** Runs a check on each pot, prints a line each, and ends the process with 1 if any failed. */
export async function checkAll(pots, check) {
    let failures = 0;
    for (const pot of pots) {
        try {
            console.log(`${pot.name}: ${await check(pot)}`);
        } catch (problem) {
            failures += 1;
            console.error(`${pot.name}: FAILED: ${problem.message}`);
        }
    }
    console.log(`${pots.length - failures} passed, ${failures} failed`);
    process.exitCode = failures === 0 ? 0 : 1;
}
