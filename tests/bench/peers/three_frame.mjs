// node three_frame.mjs POT.glb WIDTH HEIGHT FRAMES [room|floor]: three.js's MeshStandardMaterial in Debian's Chromium,
// headless and in software, one light, plain background, read back; with `room` also the filtered light of one (PMREM),
// with `floor` also a plane under the pot. Prints the milliseconds of each frame, one a line. Takes three and playwright-core from tests/web (npm ci there).
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const web = path.join(path.dirname(fileURLToPath(import.meta.url)), '../../web');
const { chromium } = createRequire(path.join(web, 'package.json'))('playwright-core');
const [pot, width, height, frames, also] = process.argv.slice(2);
if (![undefined, 'room', 'floor'].includes(also)) throw new Error(`expected room, floor or nothing, found ${also}`);
const FLAGS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
    '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];
const PAGE = `<!doctype html><canvas id="c" width="${width}" height="${height}"></canvas>
<script type="importmap">{"imports": {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
const renderer = new THREE.WebGLRenderer({ canvas: document.getElementById('c'), antialias: false });
renderer.setSize(${width}, ${height}, false);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0.2, 0.18, 0.16);
const light = new THREE.DirectionalLight(0xffffff, 3);
light.position.set(-0.74, 0.6, 0.4);
scene.add(light);
if (${also === 'room'}) scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
if (${also === 'floor'}) {
    const clay = new THREE.MeshStandardMaterial({ color: 0x6b5a48, roughness: 0.9 });
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(4, 4).rotateX(-Math.PI / 2), clay));
}
const camera = new THREE.PerspectiveCamera(26.99, ${width} / ${height}, 0.1, 5);
camera.position.set(0, 0.285, 0.805);
camera.lookAt(0, 0.082, 0);
const gltf = await new GLTFLoader().loadAsync('/pot.glb');
scene.add(gltf.scene);
const pixels = new Uint8Array(4 * ${width} * ${height});
const gl = renderer.getContext();
const times = [];
for (let frame = 0; frame < ${frames} + 3; frame += 1) {
    gltf.scene.rotation.y += 0.035;
    const start = performance.now();
    renderer.render(scene, camera);
    gl.readPixels(0, 0, ${width}, ${height}, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    if (frame >= 3) times.push(performance.now() - start);
}
let covered = 0;
for (let k = 0; k < pixels.length; k += 388) covered += Math.abs(pixels[k] - pixels[0]) > 6 ? 1 : 0;
window.outcome = { times, covered };
</script>`;

const browser = await chromium.launch({ executablePath: process.env.ONGGI_CHROMIUM ?? '/usr/bin/chromium', args: FLAGS });
try {
    const page = await browser.newPage();
    page.on('pageerror', (problem) => { console.error(problem.message); });
    await page.route('**/*', async (route) => {
        const { pathname } = new URL(route.request().url());
        if (pathname === '/') return route.fulfill({ contentType: 'text/html', body: PAGE });
        if (pathname === '/pot.glb') return route.fulfill({ contentType: 'model/gltf-binary', body: await readFile(pot) });
        if (!pathname.startsWith('/three/')) return route.fulfill({ status: 404 });
        const file = path.join(web, 'node_modules', path.normalize(pathname));
        return route.fulfill({ contentType: 'text/javascript', body: await readFile(file) });
    });
    await page.goto('http://peer.test/');
    await page.waitForFunction('window.outcome !== undefined', null, { timeout: 300_000 * Math.max(1, Number(process.env.ONGGI_SLOWNESS ?? 1)) });
    const { times, covered } = await page.evaluate('window.outcome');
    if (covered < 50) throw new Error('expected a pot in the picture, found none');
    for (const ms of times) console.log(ms.toFixed(3));
} finally {
    await browser.close();
}
