// Serves the pages, the clients of pots and the pots on 127.0.0.1, at a port of the system's choice: what a visitor's phone would
// get from the kiosk, and nothing from outside.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.glb': 'model/gltf-binary' };

/** Where a request's path lies on the disk; nothing outside the roots. */
function locate(pathname, potsFolder) {
    const roots = {
        '/pots/': potsFolder,
        '/three/': path.join(here, 'node_modules/three'),
        '/model-viewer/': path.join(here, 'node_modules/@google/model-viewer/dist'),
        '/babylon/': path.join(here, 'node_modules/babylonjs'),
        '/babylon-loaders/': path.join(here, 'node_modules/babylonjs-loaders'),
        '/playcanvas/': path.join(here, 'node_modules/playcanvas/build'),
        '/': path.join(here, 'page'),
    };
    const prefix = Object.keys(roots).find((start) => pathname.startsWith(start));
    const file = path.join(roots[prefix], pathname.slice(prefix.length));
    return file.startsWith(roots[prefix] + path.sep) ? file : null;
}

/** @returns {Promise<{origin: string, close: () => Promise<void>}>} */
export async function serve(potsFolder) {
    const server = createServer(async (request, response) => {
        const { pathname } = new URL(request.url, 'http://localhost');
        // Browsers ask for it unasked; a 404 would count as an error on the console.
        if (pathname === '/favicon.ico') return response.writeHead(204).end();
        const file = locate(decodeURIComponent(pathname), path.resolve(potsFolder));
        try {
            const bytes = await readFile(file);
            const type = TYPES[path.extname(file)] ?? 'application/octet-stream';
            // No "Cache-Control: no-store": with it, Chromium now and then reports a stream that was read to its end as
            // aborted. The browser starts with an empty cache, so nothing old is shown.
            response.writeHead(200, { 'Content-Type': type, 'Content-Length': bytes.length }).end(bytes);
        } catch {
            response.writeHead(404).end();
        }
    });
    await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
    return {
        origin: `http://127.0.0.1:${server.address().port}`,
        close: () => new Promise((done) => { server.closeAllConnections(); server.close(done); }),
    };
}
