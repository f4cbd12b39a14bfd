// A small room for clients that bring none: grey walls, a pale ceiling, a window to the left of the eye.

export const ROOM_SIDE = 64;
const WINDOW = [-0.62, 0.48, 0.62];  // direction of its middle
const ACROSS = 0.93;  // cosine of half the angle that it takes

// Of each face of a cube map, in the order +X, -X, +Y, -Y, +Z, -Z: the direction of a texel at (u, v) from -1 to 1.
const FACES = [(u, v) => [1, -v, -u], (u, v) => [-1, -v, u], (u, v) => [u, 1, v], (u, v) => [u, -1, -v],
    (u, v) => [u, -v, 1], (u, v) => [-u, -v, -1]];

function light([x, y, z]) {
    const length = Math.hypot(x, y, z);
    const facing = (x * WINDOW[0] + y * WINDOW[1] + z * WINDOW[2]) / length;
    return facing > ACROSS ? 255 : 120 + 70 * (y / length);
}

/** Six faces of ROOM_SIDE x ROOM_SIDE texels of four bytes. */
export const roomFaces = () => FACES.map((direction) => {
    const bytes = new Uint8Array(4 * ROOM_SIDE * ROOM_SIDE);
    for (let row = 0; row < ROOM_SIDE; row += 1) {
        for (let column = 0; column < ROOM_SIDE; column += 1) {
            const [u, v] = [column, row].map((texel) => (2 * texel + 1) / ROOM_SIDE - 1);
            bytes.fill(light(direction(u, v)), 4 * (row * ROOM_SIDE + column)).fill(255, 4 * (row * ROOM_SIDE + column) + 3);
        }
    }
    return bytes;
});

/** Where an eye stands that sees a box filling a picture of 30 degrees: from its middle, in half diagonals. */
export const EYE = (() => {
    const [y, z] = [0.35, 1];
    const far = 4.2 / Math.hypot(y, z);
    return [0, y * far, z * far];
})();
