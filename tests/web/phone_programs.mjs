// The programs behind a shared pot's page, run for a check: who fills the outbox, who serves it.
import { execFile, spawn } from 'node:child_process';
import { promisify } from 'node:util';

/** Puts the pot of a session into FOLDER/box; gives its code. */
export async function makeOutbox(program, session, folder, options = []) {
    const { stdout } = await promisify(execFile)(program, [session, folder, ...options]);
    return stdout.trim();
}

/** Films a session as FOLDER/film.webp and film.mp4, with its drawing as pot.svg; gives the options for makeOutbox. */
export async function makeFilm(onggi, session, folder) {
    const files = { film: `${folder}/film.webp`, mp4: `${folder}/film.mp4`, drawing: `${folder}/pot.svg` };
    await promisify(execFile)(onggi, ['film', session, '--out', files.film, '--mp4', files.mp4, '--glaze', 'celadon', '--quick', '--seconds', '2']);
    await promisify(execFile)(onggi, ['replay', session, '--drawing', files.drawing, '--fired', 'glaze']);
    return Object.entries(files).flatMap(([name, file]) => [`--${name}`, file]);
}

/** Starts a server that says its port in a line; gives where it is and how to end it. */
async function serve(command, words, port) {
    const server = spawn(command, words, { stdio: ['ignore', 'pipe', 'pipe'] });
    const said = await new Promise((found, lost) => {
        let text = '';
        const read = (bytes) => {
            text += bytes;
            const line = text.match(port);
            if (line) found(line[1]);
        };
        server.stdout.on('data', read);
        server.stderr.on('data', read);
        server.on('exit', () => lost(new Error(`${command} ended: ${text}`)));
    });
    return {
        origin: `http://127.0.0.1:${said}`,
        stop: () => new Promise((done) => { server.removeAllListeners('exit'); server.on('exit', done); server.kill('SIGTERM'); }),
    };
}

export const serveByOnggi = (program, box) =>
    serve(program, ['share', '--outbox', box, '--listen', '127.0.0.1', '--port', '0'], /port (\d+)/);

/** A plain web server, such as a house may have: Python's. */
export const serveByPython = (box) =>
    serve('python3', ['-u', '-m', 'http.server', '0', '--bind', '127.0.0.1', '--directory', box], /port (\d+)/);
