// node validate.mjs DIR: Khronos's glTF validator on every pot of DIR. Nothing is ignored: no error, warning,
// information or hint may be left. Sizes are held to the budget for phones as well.
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import validator from 'gltf-validator';
import { checkAll, listPots } from './pots.mjs';

const MAX_WIRE_BYTES = 1_000_000;  // gzip, as a web server sends it
const MAX_TRIANGLES = 50_000;

/** Throws with the first few messages unless the report is empty, but for the one of an extension that the validator
 * does not know and a museum's rights need. */
function expectClean(report, hasRights) {
    const { numErrors, numWarnings, numInfos, numHints, messages } = report.issues;
    if (hasRights) {
        const unknown = messages.filter((issue) => issue.code === 'UNSUPPORTED_EXTENSION' &&
            issue.message.includes('KHR_xmp_json_ld'));
        if (unknown.length === 1 && messages.length === 1) return;
        throw new Error(`expected one message, of KHR_xmp_json_ld, found ${JSON.stringify(messages.slice(0, 5))}`);
    }
    if (numErrors + numWarnings + numInfos + numHints === 0) return;
    const lines = messages.slice(0, 5).map((issue) => `${issue.code} at ${issue.pointer}: ${issue.message}`);
    throw new Error(`${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints\n  ` +
        lines.join('\n  '));
}

async function validate(bytes) {
    return validator.validateBytes(new Uint8Array(bytes), { maxIssues: 0, ignoredIssues: [] });
}

/** The check itself must see a fault: one bit of a stated bound is one. */
async function expectDamageIsSeen(bytes) {
    const damaged = Buffer.from(bytes);
    const at = damaged.indexOf('"max":[') + '"max":[0.0'.length;
    damaged[at] = damaged[at] === 0x39 ? 0x38 : damaged[at] + 1;
    const report = await validate(damaged);
    if (report.issues.numErrors === 0) throw new Error('the validator found nothing in a damaged file');
}

const folder = process.argv[2];
if (!folder) {
    console.error('expected: node validate.mjs DIR');
    process.exit(2);
}
console.log(`gltf-validator ${validator.version()}`);
await checkAll(await listPots(folder), async (pot) => {
    const bytes = await readFile(pot.file);
    const report = await validate(bytes);
    expectClean(report, pot.has_rights ?? false);
    await expectDamageIsSeen(bytes);
    const { totalTriangleCount, totalVertexCount } = report.info;
    if (totalTriangleCount !== pot.triangles) throw new Error(`expected ${pot.triangles} triangles, found ${totalTriangleCount}`);
    if (totalTriangleCount > MAX_TRIANGLES) throw new Error(`${totalTriangleCount} triangles are over the budget`);
    const wire = gzipSync(bytes, { level: 9 }).length;
    if (wire > MAX_WIRE_BYTES) throw new Error(`${wire} bytes on the wire are over the budget`);
    return `0 errors, 0 warnings, ${pot.has_rights ? 1 : 0} infos, 0 hints; ${totalTriangleCount} triangles, ${totalVertexCount} vertices, ` +
        `${bytes.length} bytes, ${wire} gzipped`;
});
