// The pot of the page, turning: its outline, bent by axis and dents of a pot that is not round, one picture wrapped round it,
// WebGL 2.
// The page is whole without: it shows the poster, and goes on doing so where the phone saves data or cannot draw.
'use strict';

const SEGMENTS = 128;
const TURN_MS = 9000;
const CAMERA = { far: 300, up: 0.16 };  // so many times the pot's size away; radians above its middle

const VERTEX = `#version 300 es
in vec3 place; in vec3 normal; in vec3 skin;  // skin: around, down the wall, 1 inside
uniform mat4 view; uniform float turn;
out vec3 at; out vec3 across; out vec3 on;
vec3 turned(vec3 p) { float c = cos(turn), s = sin(turn); return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x); }
void main() {
  at = turned(place); across = turned(normal); on = skin;
  gl_Position = view * vec4(at, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec3 at; in vec3 across; in vec3 on;
uniform sampler2D surface; uniform bool wrapped;
uniform vec3 colour; uniform vec3 eye; uniform float gloss; uniform vec2 rim;  // rim: radius, height
out vec4 light;
const vec3 SUN = vec3(-0.56, 0.62, 0.55);
vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
// The tone curve of the wheel's screen: the build puts the numbers of shaders/curve.h in.
vec3 shown(vec3 c) { c = c / (@kCurveSlope@ * c + @kCurveFoot@); return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
// What is mirrored: a warm room, a window before and to the left of the pot, a lighter floor.
vec3 room(vec3 r, float blur) {
  vec3 c = mix(vec3(0.15, 0.11, 0.07), vec3(0.05, 0.04, 0.03), smoothstep(0.0, 0.9, abs(r.y)));
  vec2 w = vec2(atan(r.x, r.z) + 0.75, asin(clamp(r.y, -1.0, 1.0)) - 0.62);
  vec2 pane = smoothstep(vec2(0.42, 0.34) + blur, vec2(0.34, 0.26) - blur, abs(w));
  float bar = 0.35 + 0.65 * smoothstep(0.012, 0.03 + blur, abs(w.x)) * smoothstep(0.012, 0.03 + blur, abs(w.y));
  return c + vec3(4.6, 4.4, 4.1) * pane.x * pane.y * mix(bar, 1.0, min(1.0, blur * 4.0));
}
void main() {
  vec3 n = normalize(across), v = normalize(eye - at);
  bool inside = on.z > 0.5;
  vec3 sun = normalize(SUN);
  vec3 base = colour;
  if (wrapped && !inside) base = linear(texture(surface, on.xy).rgb);
  else {  // the glaze runs a little thinner at rim and ridges
    float ridge = sin(at.y * 0.9 + on.x * 6.2832) * 0.5 + sin(at.y * 0.37) * 0.5;
    base *= 1.0 + 0.05 * ridge;
    base = mix(base, base * 1.3 + 0.02, smoothstep(5.0, 0.0, rim.y - at.y) * 0.5);
    n = normalize(n + vec3(0.0, 0.035 * cos(at.y * 0.9 + on.x * 6.2832), 0.0));
  }
  float lit = pow(clamp((dot(n, sun) + 0.35) / 1.35, 0.0, 1.0), 1.5), open = 1.0;
  if (inside) {
    float deep = max(rim.y - at.y, 0.0);
    vec3 out_of = at + sun * (deep / sun.y);
    lit *= 1.0 - smoothstep(rim.x * 0.86, rim.x * 1.02, length(out_of.xz));
    open = 1.0 / (1.0 + 1.4 * pow(deep / rim.x, 2.0));
  } else open = 0.6 + 0.4 * smoothstep(0.0, 0.2 * rim.y, at.y);
  vec3 sky = mix(vec3(0.13, 0.09, 0.06), vec3(0.30, 0.29, 0.28), n.y * 0.5 + 0.5) + vec3(0.05, 0.045, 0.04) * n.x;
  vec3 c = base * (sky * open + vec3(0.98, 0.9, 0.76) * lit);
  float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(n, v), 0.0), 5.0);
  float mirror = fresnel * gloss * (inside ? 0.35 * open : open);
  c = c * (1.0 - mirror * 0.5) + room(reflect(-v, n), 0.25 * (1.0 - gloss)) * mirror * 1.6;
  light = vec4(shown(c), 1.0);
}`;

/** "50,0 54.2,5" as [[50, 0], [54.2, 5]]. */
const points = (text) => text.split(' ').filter(Boolean).map((pair) => pair.split(',').map(Number));

/** Rings from under the foot up the outside, over the rim, down the inside: radius, height, down the wall 0 to 1, inside. */
function ringsOf(outside, inside) {
  const rings = [[0.01, outside[0][1] + 2, 1, 0], [outside[0][0] * 0.78, outside[0][1] + 2, 1, 0],
    [outside[0][0] * 0.86, outside[0][1], 1, 0]];
  const along = [0];
  for (let i = 1; i < outside.length; i += 1) {
    along.push(along[i - 1] + Math.hypot(outside[i][0] - outside[i - 1][0], outside[i][1] - outside[i - 1][1]));
  }
  const length = along[along.length - 1] || 1;
  outside.forEach(([radius, height], i) => rings.push([radius, height, 1 - along[i] / length, 0]));
  const top = outside[outside.length - 1];
  const down = inside.length > 1 ? inside : [[Math.max(0.01, top[0] - 5), top[1]], [0.01, top[1]]];
  // The lip between the walls, as high as the solid's.
  const lip = (top[0] - down[0][0]) / 2;
  for (let k = 1; lip > 0 && k < 6; k += 1) {
    const angle = (k / 6) * Math.PI;
    rings.push([top[0] - lip + lip * Math.cos(angle), top[1] + (down[0][1] - top[1]) * (k / 6), 0, 0]);
  }
  down.forEach(([radius, height]) => rings.push([Math.max(radius, 0.01), height, 0, 1]));
  const last = down[down.length - 1];
  if (last[0] > 0.5) rings.push([0.01, last[1], 0, 1]);
  return rings;
}

/** Rows of lengths from foot to rim, in mm: each its height, and then its centre or its dents. */
const rowsOf = (text) => (text ? text.split(' ').map((row) => row.split(',').map((number) => number / 20)) : []);

/** The line with points between its own, so that it has one at each of those heights, which rise. */
function atHeights(line, heights) {
  return line.flatMap((to, i) => {
    const from = line[Math.max(0, i - 1)];
    const between = heights.filter((height) => (height - from[1]) * (height - to[1]) < 0);
    if (to[1] < from[1]) between.reverse();
    const part = (height) => (height - from[1]) / (to[1] - from[1]);
    return [...between.map((height) => [from[0] + (to[0] - from[0]) * part(height), height]), to];
  });
}

/** Gives the lengths of the rows at a height. */
function between(rows) {
  return (height) => {
    const reached = rows.findIndex((row) => row[0] >= height);
    const high = reached < 0 ? rows.length - 1 : reached;
    const [one, other] = [rows[Math.max(0, high - 1)], rows[high]];
    const part = Math.min(1, Math.max(0, (height - one[0]) / (other[0] - one[0] || 1)));
    return one.slice(1).map((length, i) => length + (other[i + 1] - length) * part);
  };
}

/** Gives the place of a ring's corner: [across, height, to the eye]. A round pot has no axis, and may have no dents. */
function placeOf(axis, dents) {
  const [centreAt, dentsAt] = [axis, dents].map((rows) => (rows.length > 0 ? between(rows) : () => [0, 0]));
  return (radius, height) => {
    const [[across, near], row] = [centreAt(height), dentsAt(height)];
    return (k) => {
      const angle = (k / SEGMENTS) * 2 * Math.PI;
      const sector = ((k % SEGMENTS) / SEGMENTS) * row.length;
      const first = Math.floor(sector);
      const [one, other] = [row[first], row[(first + 1) % row.length]];
      const bent = Math.max(Math.min(radius, 0.5), radius + one + (other - one) * (sector - first));
      return [across + bent * Math.cos(angle), height, near - bent * Math.sin(angle)];
    };
  };
}

/** Nine numbers a corner - place, normal, skin - and the triangles between. */
function meshOf(rings, place) {
  const corners = [];
  const triangles = [];
  const places = rings.map(([radius, height]) => {
    const corner = place(radius, height);
    return Array.from({ length: SEGMENTS }, (_, k) => corner(k));
  });
  const way = (from, to) => to.map((x, axis) => x - from[axis]);
  rings.forEach(([, , down, within], i) => {
    const [before, here, after] = [Math.max(0, i - 1), i, Math.min(rings.length - 1, i + 1)].map((ring) => places[ring]);
    for (let k = 0; k <= SEGMENTS; k += 1) {
      const [left, at, right] = [k + SEGMENTS - 1, k, k + 1].map((corner) => corner % SEGMENTS);
      // The normal stands on the way along the wall and on the way round.
      const [p, q] = [way(before[at], after[at]), way(here[left], here[right])];
      const normal = [q[1] * p[2] - q[2] * p[1], q[2] * p[0] - q[0] * p[2], q[0] * p[1] - q[1] * p[0]];
      const size = Math.hypot(...normal) || 1;
      corners.push(...here[at], ...normal.map((x) => x / size), k / SEGMENTS, down, within);
      if (i + 1 === rings.length || k === SEGMENTS) continue;
      const a = i * (SEGMENTS + 1) + k;
      const b = a + SEGMENTS + 1;
      triangles.push(a, a + 1, b, b, a + 1, b + 1);
    }
  });
  return { corners: new Float32Array(corners), triangles: new Uint32Array(triangles) };
}

/** The view of a pot that fills a canvas so shaped, its foot on the board; columns first. */
function viewOf(radius, height, aspect, board) {
  const [sin, cos] = [Math.sin(CAMERA.up), Math.cos(CAMERA.up)];
  // Half of what is seen, mm: across, and up between the foot's and the mouth's nearest and farthest points.
  const tall = (height * cos + 2 * radius * sin) / 2;
  const half = Math.max(tall * 1.06 / (1 - board), radius * 1.16 / aspect);
  const far = CAMERA.far * half;
  const eye = [0, height / 2 + far * sin, far * cos];
  const [near, beyond] = [far - 3 * half, far + 3 * half];
  const scale = far / half;
  // The foot's near edge comes to stand a little above the canvas's lower edge.
  const shift = -1 + 2 * board + tall / half;
  const a = (beyond + near) / (near - beyond);
  const b = (2 * beyond * near) / (near - beyond);
  // Rows of the looking matrix: right, up, back.
  const up = [0, cos, -sin];
  const back = [0, sin, cos];
  const to = (axis) => -(axis[1] * eye[1] + axis[2] * eye[2]);
  const column = (x, y, z, w) => [x * scale / aspect, y * scale - shift * z, a * z + b * w, -z];
  const columns = [column(1, 0, 0, 0), column(0, up[1], back[1], 0), column(0, up[2], back[2], 0),
    column(0, to(up), to(back), 1)];
  return { eye, matrix: new Float32Array(columns.flat()) };
}

function programOf(gl) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  ['place', 'normal', 'skin'].forEach((name, i) => gl.bindAttribLocation(program, i, name));
  gl.linkProgram(program);
  return gl.getProgramParameter(program, gl.LINK_STATUS) ? program : null;
}

/** Gives a function that draws the pot at an angle; null where the phone cannot. */
function painterOf(canvas, stage, picture) {
  const gl = canvas.getContext('webgl2', { alpha: true, antialias: true });
  const program = gl && programOf(gl);
  if (!program) return null;
  const lines = [stage.dataset.outside, stage.dataset.inside].map(points);
  const top = lines[0][lines[0].length - 1];
  const axis = rowsOf(stage.dataset.axis);
  const dents = rowsOf(stage.dataset.dents).map((row, i, rows) => [(top[1] * i) / (rows.length - 1), ...row]);
  const heights = [...axis, ...dents].map((row) => row[0]).sort((one, other) => one - other);
  const [outside, inside] = lines.map((line) => atHeights(line, heights));
  const mesh = meshOf(ringsOf(outside, inside), placeOf(axis, dents));
  const radius = Number(stage.dataset.reach) || Math.max(...outside.map((point) => point[0]));
  gl.useProgram(program);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, mesh.corners, gl.STATIC_DRAW);
  [0, 1, 2].forEach((i) => {
    gl.enableVertexAttribArray(i);
    gl.vertexAttribPointer(i, 3, gl.FLOAT, false, 36, 12 * i);
  });
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.triangles, gl.STATIC_DRAW);
  const uniform = (name) => gl.getUniformLocation(program, name);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  if (picture) {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.generateMipmap(gl.TEXTURE_2D);
  } else {
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([255, 255, 255, 255]));
  }
  gl.uniform1i(uniform('wrapped'), picture ? 1 : 0);
  gl.uniform3fv(uniform('colour'), stage.dataset.colour.split(' ').map(Number));
  gl.uniform1f(uniform('gloss'), Number(stage.dataset.gloss));
  gl.uniform2f(uniform('rim'), top[0], top[1]);
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.CULL_FACE);  // the pot is closed
  return (angle) => {
    const dense = Math.min(2, devicePixelRatio || 1);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((px) => Math.round(px * dense));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    const view = viewOf(radius, top[1], width / height, 14 / canvas.clientHeight);
    gl.viewport(0, 0, width, height);
    gl.uniformMatrix4fv(uniform('view'), false, view.matrix);
    gl.uniform3fv(uniform('eye'), view.eye);
    gl.uniform1f(uniform('turn'), angle);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.drawElements(gl.TRIANGLES, mesh.triangles.length, gl.UNSIGNED_INT, 0);
  };
}

/** A button that stops the turning and lets it go on. */
function turnButton(stage, turning, set) {
  const button = document.createElement('button');
  const show = () => {
    button.setAttribute('aria-label', turning() ? stage.dataset.stop : stage.dataset.go);
    button.innerHTML = turning() ? '<svg viewBox="0 0 24 24"><path d="M5 4h5v16H5zM14 4h5v16h-5z"/></svg>'
      : '<svg viewBox="0 0 24 24"><path d="M12 4V0l6 6-6 6V7a6 6 0 1 0 6 6h3a9 9 0 1 1-9-9z"/></svg>';
  };
  button.type = 'button';
  button.onclick = () => { set(!turning()); show(); };
  show();
  return button;
}

function start(stage, picture) {
  const canvas = document.createElement('canvas');
  stage.append(canvas);
  const draw = painterOf(canvas, stage, picture);
  if (!draw) return canvas.remove();
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', stage.dataset.say);
  canvas.tabIndex = 0;
  let angle = 0;  // as the poster shows it
  let turns = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  let seen = true;
  let held = null;
  let before = 0;
  let asked = false;
  const ask = () => {
    if (!asked) requestAnimationFrame(frame);
    asked = true;
  };
  function frame(now) {
    asked = false;
    const goes = turns && held === null;
    if (goes && before) angle += (Math.min(now - before, 100) / TURN_MS) * 2 * Math.PI;
    before = goes ? now : 0;
    draw(angle);
    stage.classList.add('drawn');
    if (goes && seen && !document.hidden) ask();
    else before = 0;
  }
  canvas.onpointerdown = (event) => { held = event.clientX; canvas.setPointerCapture(event.pointerId); };
  canvas.onpointermove = (event) => {
    if (held === null) return;
    angle += (event.clientX - held) / 110;
    held = event.clientX;
    ask();
  };
  canvas.onpointerup = canvas.onpointercancel = () => { held = null; ask(); };
  canvas.onkeydown = (event) => {
    const step = { ArrowLeft: -0.2, ArrowRight: 0.2 }[event.key];
    if (!step) return;
    angle += step;
    event.preventDefault();
    ask();
  };
  canvas.addEventListener('webglcontextlost', () => { canvas.remove(); stage.classList.remove('drawn'); });
  document.addEventListener('visibilitychange', ask);
  addEventListener('resize', ask);
  new IntersectionObserver((entries) => { seen = entries[entries.length - 1].isIntersecting; ask(); }).observe(stage);
  stage.append(turnButton(stage, () => turns, (on) => { turns = on; ask(); }));
  ask();
}

/** The film in its place, once; then its still again. */
function playFilm(link) {
  const film = new Image();
  film.alt = '';
  film.src = link.href;
  film.onload = () => setTimeout(() => { film.remove(); link.classList.remove('playing'); }, Number(link.dataset.seconds) * 1000);
  film.onerror = () => { film.remove(); link.classList.remove('playing'); };
  link.classList.add('playing');
  link.append(film);
}

/** The film runs by itself once it is seen; where the phone cannot play it, the animated picture is in its place. */
function startVideo(video, sparing) {
  const replace = () => video.replaceWith(...video.querySelectorAll('a'));
  if (!video.canPlayType('video/mp4; codecs="avc1.64000D"')) return replace();
  video.querySelector('source').onerror = replace;
  if (sparing || matchMedia('(prefers-reduced-motion: reduce)').matches) return;
  new IntersectionObserver((entries, observer) => {
    if (!entries[entries.length - 1].isIntersecting) return;
    observer.disconnect();
    video.autoplay = true;
    video.play().catch(() => {});  // some phones want to be asked
  }).observe(video);
}

/** Picture and film for the phone's own sheet of places to send or keep them; null where it takes no files. */
function sharedFiles(links) {
  const names = links.filter((link) => /\.(png|jpg|mp4)$/.test(link.download));
  const sample = new File([], 'film.mp4', { type: 'video/mp4' });
  if (names.length === 0 || !navigator.canShare || !navigator.canShare({ files: [sample] })) return null;
  return () => Promise.all(names.map(async (link) => {
    const content = await (await fetch(link.href)).blob();
    return new File([content], link.download, { type: content.type });
  }));
}

function offerSharing(button, fetchFiles) {
  let files = null;
  const ready = () => { files = files || fetchFiles().catch(() => { files = null; return []; }); return files; };
  button.hidden = false;
  button.onpointerdown = ready;  // the sheet opens only shortly after the touch
  button.onclick = async () => navigator.share({ files: await ready() }).catch(() => {});
}

addEventListener('load', () => {
  const film = document.getElementById('film');
  if (film) film.onclick = (event) => { event.preventDefault(); if (!film.classList.contains('playing')) playFilm(film); };
  const android = document.getElementById('ar');
  if (android && /Android/.test(navigator.userAgent)) android.hidden = false;
  const room = document.getElementById('room');
  if (room && room.relList.supports('ar')) {
    room.hidden = false;
    // iOS opens the room at once only for a link around nothing but a picture; for others it shows the file first.
    room.onclick = (event) => {
      event.preventDefault();
      const link = document.createElement('a');
      link.rel = 'ar';
      link.href = room.href;
      link.append(document.createElement('img'));
      link.click();
    };
  }

  const button = document.getElementById('share');
  const fetchFiles = button && sharedFiles([...document.querySelectorAll('.files a')]);
  if (fetchFiles) offerSharing(button, fetchFiles);
  const isApple = /iP(hone|ad|od)/.test(navigator.userAgent) || (/Macintosh/.test(navigator.userAgent) && navigator.maxTouchPoints > 1);
  const hint = document.getElementById('iphone');
  if (hint && isApple && !fetchFiles) hint.hidden = false;

  const stage = document.getElementById('stage');
  const link = navigator.connection || {};
  const sparing = link.saveData || /2g/.test(link.effectiveType || '');
  const video = document.getElementById('video');
  if (video) startVideo(video, sparing);
  if (!stage.dataset.outside || sparing) return;
  if (!stage.dataset.surface) return start(stage, null);
  const picture = new Image();
  picture.onload = () => start(stage, picture);
  picture.onerror = () => start(stage, null);
  picture.src = stage.dataset.surface;
});
