// Loads ?pot=NAME with three.js's own loader, draws it once, and leaves in window.found what it saw. ?usdz loads the
// USDZ in place of the GLB. ?room=1 puts it into a room that glazes mirror.
import * as THREE from 'three';
import { RoomEnvironment } from '/three/examples/jsm/environments/RoomEnvironment.js';
import { GLTFLoader } from '/three/examples/jsm/loaders/GLTFLoader.js';
import { USDLoader } from '/three/examples/jsm/loaders/USDLoader.js';

const SIZE_PX = 480;
const BACKGROUND = 0x202428;

function describe(gltf) {
    const box = new THREE.Box3().setFromObject(gltf.scene, true);
    const meshes = [];
    gltf.scene.traverse((node) => { if (node.isMesh) meshes.push(node); });
    const [mesh] = meshes;
    const { material, geometry } = mesh;
    return {
        min: box.min.toArray(),
        max: box.max.toArray(),
        meshes: meshes.length,
        triangles: (geometry.index ?? geometry.attributes.position).count / 3,
        identity: mesh.matrixWorld.equals(new THREE.Matrix4()),
        generator: gltf.asset.generator,
        extras: gltf.asset.extras,
        material: {
            type: material.type,
            colour: material.color.toArray(),  // linear
            roughness: material.roughness,
            metalness: material.metalness,
            side: material.side === THREE.FrontSide ? 'front' : 'other',
            textured: Boolean(material.map || material.normalMap || material.roughnessMap),
            maps: Object.fromEntries(['map', 'normalMap', 'roughnessMap', 'aoMap', 'clearcoatMap']
                .map((name) => [name, Boolean(material[name])])),
            tangents: meshes[0].geometry.hasAttribute('tangent'),
        },
    };
}

/** The pictures of a USDZ come in after its scene, and nothing tells when. */
async function picturesOf(scene) {
    const textures = [];
    scene.traverse((node) => { if (node.isMesh) textures.push(...Object.values(node.material).filter((value) => value?.isTexture)); });
    while (textures.some((texture) => !texture.image)) await new Promise((resolve) => { setTimeout(resolve, 20); });
}

function draw(gltf, inRoom) {
    const scene = new THREE.Scene();
    scene.background = new THREE.Color(BACKGROUND);
    scene.add(gltf.scene);
    const lamp = new THREE.DirectionalLight(0xffffff, 3.0);
    lamp.position.set(-1, 1.2, 1.5);
    if (!inRoom) scene.add(lamp, new THREE.HemisphereLight(0xbfd0e0, 0x403028, 0.8));

    const box = new THREE.Box3().setFromObject(gltf.scene, true);
    const centre = box.getCenter(new THREE.Vector3());
    const radius = box.getSize(new THREE.Vector3()).length() / 2;
    const camera = new THREE.PerspectiveCamera(30, 1, radius / 10, radius * 20);
    camera.position.copy(centre).add(new THREE.Vector3(0, 0.35, 1).normalize().multiplyScalar(radius * 4.2));
    camera.lookAt(centre);

    const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    renderer.setSize(SIZE_PX, SIZE_PX);
    if (inRoom) {
        scene.environment = new THREE.PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
        renderer.toneMapping = THREE.NeutralToneMapping;
    }
    document.body.append(renderer.domElement);
    renderer.render(scene, camera);
    return renderer;
}

/** Share of pixels that are not background, and the mean luminance of those (0 to 255). */
function look(renderer) {
    const gl = renderer.getContext();
    const pixels = new Uint8Array(SIZE_PX * SIZE_PX * 4);
    gl.readPixels(0, 0, SIZE_PX, SIZE_PX, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let covered = 0;
    let luminance = 0;
    for (let i = 0; i < pixels.length; i += 4) {
        const [r, g, b] = pixels.subarray(i, i + 3);
        const far = Math.max(Math.abs(r - 0x20), Math.abs(g - 0x24), Math.abs(b - 0x28)) > 6;
        if (!far) continue;
        covered += 1;
        luminance += 0.2126 * r + 0.7152 * g + 0.0722 * b;
    }
    return { coverage: covered / (SIZE_PX * SIZE_PX), luminance: luminance / Math.max(1, covered) };
}

try {
    const asked = new URLSearchParams(location.search);
    const name = asked.get('pot');
    const gltf = asked.has('usdz') ? { scene: await new USDLoader().loadAsync(`/pots/${name}.usdz`), asset: {} }
        : await new GLTFLoader().loadAsync(`/pots/${name}.glb`);
    if (asked.has('usdz')) await picturesOf(gltf.scene);
    const facts = describe(gltf);
    window.found = { ...facts, ...look(draw(gltf, asked.has('room'))) };
} catch (problem) {
    window.found = { error: String(problem) };
}
