// node phone_page.mjs ONGGI MAKE_OUTBOX SESSION FOLDER: opens a shared pot's page as phones and tablets do, in every
// language, by the kiosk's server and by a plain web server, and looks at what arrived. Writes screenshots.
import { mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { expect, launch, PATIENCE, SLOWNESS, watch } from './browser.mjs';
import { difference, makePictures, silhouette } from './phone_pictures.mjs';
import { makeFilm, makeOutbox, serveByOnggi, serveByPython } from './phone_programs.mjs';
import { tooFaint, tooSmall, unnamed } from './phone_rules.mjs';

const LANGUAGES = { en: 'ltr', ko: 'ltr', ar: 'rtl' };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const TABLET = { viewport: { width: 820, height: 1180 }, hasTouch: true };
const DRAWN = PATIENCE;

const [onggi, makeProgram, session, folder] = process.argv.slice(2);
if (!folder) {
    console.error('expected: node phone_page.mjs ONGGI MAKE_OUTBOX SESSION FOLDER');
    process.exit(2);
}

/** A phone's own world, which is patient on a slow machine. */
async function contextOf(browser, options) {
    const context = await browser.newContext(options);
    context.setDefaultTimeout(PATIENCE.timeout);
    return context;
}

/** Looks until it is so. */
async function comesTrue(condition, words) {
    const end = Date.now() + PATIENCE.timeout;
    while (!await condition()) expect(Date.now() < end, words);
}

async function opened(browser, origin, path, options, ready = '.drawn') {
    const context = await contextOf(browser, { acceptDownloads: true, ...options });
    const page = await context.newPage();
    const complaints = watch(page, origin);
    await page.goto(origin + path);
    if (ready) await page.waitForSelector(ready, DRAWN);
    return { context, page, complaints };
}

/** The pot covers a good part of its stage, turns, obeys a finger and the button. */
async function expectDrawnPot(browser, page) {
    const stage = page.locator('#stage');
    await page.locator('#stage button').click();
    let still = await stage.screenshot();
    await comesTrue(async () => {
        const before = still;
        await page.waitForTimeout(200 * SLOWNESS);
        still = await stage.screenshot();
        return await difference(browser, before, still) === 0;
    }, 'expected the button to stop the pot');
    const box = await stage.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2, { steps: 4 });
    await page.mouse.up();
    await comesTrue(async () => await difference(browser, still, await stage.screenshot()) > 0.01,
        'expected a finger to turn the pot, found it as it was');
    await page.locator('#stage canvas').press('ArrowLeft');
    await page.waitForTimeout(150);
    await page.evaluate(() => { document.querySelector('#stage canvas').style.visibility = 'hidden'; });
    const empty = await stage.screenshot();
    const covered = await difference(browser, still, empty);
    expect(covered > 0.2 && covered < 0.75, `expected a pot on the stage, found ${covered} covered`);
    return covered;
}

/** Each file, saved as a visitor saves it, is the one that was put, to the byte. */
async function expectFiles(page, code) {
    for (const [name, ending] of [['pot.png', 'png'], ['pot.glb', 'glb'], ['pot.stl', 'stl'], ['film.webp', 'webp']]) {
        const [download] = await Promise.all([
            page.waitForEvent('download'), page.locator(`.files a[href="${name}"]`).click()]);
        expect(download.suggestedFilename() === `onggi-${code}.${ending}`, `found ${download.suggestedFilename()}`);
        const saved = await readFile(await download.path());
        const put = await readFile(`${folder}/${name}`);
        expect(saved.equals(put), `${name}: expected ${put.length} bytes as they were put, found others`);
    }
}

async function lookAt(browser, origin, code, language, look, scheme, name) {
    const { context, page, complaints } = await opened(browser, origin, `/${code}/${language}.html`,
        { ...look, colorScheme: scheme, locale: 'de-DE' });
    const said = await page.evaluate(() => [document.documentElement.lang, document.documentElement.dir,
        document.documentElement.scrollWidth <= innerWidth, document.cookie]);
    expect(said[0] === language && said[1] === LANGUAGES[language], `found ${said}`);
    expect(said[2], 'expected nothing beside the screen');
    expect(said[3] === '', 'expected no cookie');
    for (const rule of [unnamed, tooSmall, tooFaint]) {
        const broken = await page.evaluate(rule);
        expect(broken.length === 0, `${rule.name}: ${broken.join('; ')}`);
    }
    await page.screenshot({ path: `${folder}/${name}.png`, fullPage: true });
    const covered = await expectDrawnPot(browser, page);
    expect(complaints.length === 0, complaints.join('; '));
    await context.close();
    return `${(100 * covered).toFixed(0)} % of the stage covered`;
}

const CHECKS = {};

for (const [look, form, scheme, languages] of [[PHONE, 'phone', 'dark', ['en', 'ko', 'ar']], [PHONE, 'phone', 'light', ['ko']],
    [TABLET, 'tablet', 'light', ['en', 'ar']], [TABLET, 'tablet', 'dark', ['ko']]]) {
    for (const language of languages) {
        const name = `${form}-${scheme}-${language}`;
        CHECKS[name] = ({ browser, own, code }) => lookAt(browser, own.origin, code, language, look, scheme, name);
    }
}

CHECKS['languages and files'] = async ({ browser, own, code }) => {
    const { context, page, complaints } = await opened(browser, own.origin, `/${code}/`, PHONE);
    expect(await page.getAttribute('html', 'lang') === 'en', 'expected the language of the visit');
    await expectFiles(page, code);
    await page.click('nav a[lang="ar"]');
    await page.waitForSelector('html[dir="rtl"] .drawn', DRAWN);
    await page.click('#film');
    await page.waitForSelector('#film.playing img[src$="film.webp"]');
    expect(complaints.length === 0, complaints.join('; '));
    await context.close();
    return 'four files to the byte';
};

CHECKS['without a script'] = async ({ browser, own, code }) => {
    const { context, page, complaints } = await opened(browser, own.origin, `/${code}/`,
        { ...PHONE, javaScriptEnabled: false }, '#stage img');
    await page.screenshot({ path: `${folder}/no-script.png`, fullPage: true });
    const links = await page.locator('.files a:visible').count();
    expect(links === 4, `expected four files to save, found ${links}`);
    await expectFiles(page, code);
    await page.click('nav a[lang="ko"]');
    await page.waitForSelector('html[lang="ko"]');
    expect(complaints.length === 0, complaints.join('; '));
    await context.close();
    return 'poster, links, languages';
};

CHECKS['letters twice as large'] = async ({ own, code }) => {
    const large = await launch(['--blink-settings=defaultFontSize=32']);
    try {
        const { context, page } = await opened(large, own.origin, `/${code}/`, PHONE);
        const [is_within, high] = await page.evaluate(() => [document.documentElement.scrollWidth <= innerWidth,
            document.querySelector('.token').getBoundingClientRect().height]);
        await page.screenshot({ path: `${folder}/large-letters.png`, fullPage: true });
        expect(is_within, 'expected nothing beside the screen');
        expect(high >= 2 * 56, `expected a button of 112 px at least, found ${high}`);
        await context.close();
        return 'buttons grow with them, nothing beside the screen';
    } finally {
        await large.close();
    }
};

CHECKS['less motion, and saved data'] = async ({ browser, own, code }) => {
    const calm = await opened(browser, own.origin, `/${code}/`, { ...PHONE, reducedMotion: 'reduce' });
    const stage = calm.page.locator('#stage');
    const before = await stage.screenshot();
    await calm.page.waitForTimeout(400);
    expect(await difference(browser, before, await stage.screenshot()) === 0, 'expected a pot at rest');
    await calm.context.close();
    const context = await contextOf(browser, PHONE);
    await context.addInitScript(() => Object.defineProperty(navigator, 'connection', { value: { saveData: true } }));
    const page = await context.newPage();
    const asked = [];
    page.on('request', (request) => asked.push(new URL(request.url()).pathname.split('/').pop()));
    await page.goto(`${own.origin}/${code}/`, { waitUntil: 'load' });
    await page.waitForTimeout(300);
    expect(await page.locator('canvas').count() === 0, 'expected the poster to stay');
    expect(!asked.includes('surface.webp'), 'expected no texture to be fetched');
    await context.close();
    return 'at rest; poster only';
};

/** The stage of 480 pixels as poster or as drawn, on a ground of one colour, with the board where the poster has it. */
async function shownAlone(page, which) {
    await page.addStyleTag({ content: `.stage { width: 359px !important; height: 359px !important; min-height: 0 !important;
        max-height: none !important; margin: 0 !important; background: #00f !important; }
        .stage::before, .stage::after, .stage button { display: none !important; }
        .stage > ${which === 'canvas' ? 'img' : 'canvas'} { visibility: hidden !important; }
        .stage > ${which} { visibility: visible !important; }` });
    await page.evaluate(() => dispatchEvent(new Event('resize')));
    await page.waitForTimeout(300 * SLOWNESS);
    return page.locator('#stage').screenshot();
}

/** Within how many pixels, in any direction, each covered pixel of one silhouette has a covered one of the other. */
function mostApart(one, other) {
    const isWithin = (rows, around, px) => rows.every((row, y) => {
        const near = around.slice(Math.max(0, y - px), y + px + 1).filter(Boolean);
        return !row || (near.length > 0 && row[0] >= Math.min(...near.map(([left]) => left)) - px &&
            row[1] <= Math.max(...near.map(([, right]) => right)) + px);
    });
    let px = 0;
    while (px < 20 && !(isWithin(one, other, px) && isWithin(other, one, px))) px += 1;
    return px;
}

/** Silhouettes of a dented, a lopsided and a round pot on the page, which must be those of their posters. */
async function posterAndPage(browser, own, put) {
    const found = [];
    for (const sample of ['studio_dented', 'studio_lopsided', 'studio_cylinder']) {
        const code = await makeOutbox(makeProgram, sample, put, ['--glaze', 'porcelain']);
        const look = { viewport: { width: 500, height: 900 }, deviceScaleFactor: 480 / 359, reducedMotion: 'reduce', bypassCSP: true };
        const silhouettes = [];
        for (const which of ['img', 'canvas']) {
            const { context, page } = await opened(browser, own.origin, `/${code}/`, look);
            const png = await shownAlone(page, which);
            await writeFile(`${folder}/${sample}-${which}.png`, png);
            silhouettes.push(await silhouette(browser, png));
            await context.close();
        }
        const apart = mostApart(...silhouettes);
        expect(apart <= 1, `${sample}: expected page and poster within a pixel, found ${apart}`);
        found.push(silhouettes[1]);
    }
    return found;
}

CHECKS['a pot that is not round'] = async ({ browser }) => {
    const found = [];
    const apart = `${folder}/off-round`;  // its files are others
    await makeOutbox(makeProgram, 'studio_dented', apart);
    const own = await serveByOnggi(onggi, `${apart}/box`);
    try {
        found.push(...await posterAndPage(browser, own, apart));
    } finally {
        await own.stop();
    }
    const [dented, lopsided, round] = found;
    for (const [name, bent] of Object.entries({ dented, lopsided })) {
        expect(mostApart(bent, round) > 1, `expected a ${name} pot to be another than a round one`);
    }
    return 'page and poster within a pixel, dented, lopsided and round';
};

/** A page with a film of two seconds, in a folder of its own. */
async function filmed(use) {
    const apart = `${folder}/filmed`;
    await mkdir(apart, { recursive: true });
    const options = await makeFilm(onggi, session, apart);
    const code = await makeOutbox(makeProgram, session, apart, [...options, '--url', 'https://museum.example/pots']);
    const own = await serveByOnggi(onggi, `${apart}/box`);
    try {
        return await use(own, `/${code}/`, apart);
    } finally {
        await own.stop();
    }
}

/** A drawing opened in the browser, under the server's policy: black lines of its own widths, not a black shape. */
CHECKS['a drawing in the browser'] = ({ browser }) => filmed(async (own, path) => {
    const context = await contextOf(browser, PHONE);
    const page = await context.newPage();
    const complaints = watch(page, own.origin);
    await page.goto(`${own.origin}${path}pot.svg`);
    const widths = await page.evaluate(() => [...new Set([...document.querySelectorAll('path')]
        .map((line) => getComputedStyle(line)).filter((style) => style.stroke !== 'none').map((style) => parseFloat(style.strokeWidth)))].sort());
    await page.screenshot({ path: `${folder}/drawing.png` });
    expect(complaints.length === 0, complaints.join('; '));
    expect(widths.includes(0.13) && widths.includes(0.5), `expected lines of 0.13 to 0.5 mm, found ${widths}`);
    await context.close();
    return `lines of ${widths.join(', ')} mm`;
});

CHECKS['a film as MP4'] = ({ browser }) => filmed(async (own, path, apart) => {
    const { context, page, complaints } = await opened(browser, own.origin, path, PHONE);
    const at = () => page.$eval('#video', (video) => [video.paused, video.currentTime, video.duration, video.videoWidth]);
    expect((await at())[0], 'expected a film at rest below the screen');
    await page.locator('#video').scrollIntoViewIfNeeded();
    await comesTrue(async () => (await at())[1] > 1.5, 'expected the film to run by itself');
    await page.locator('#video').screenshot({ path: `${folder}/film-late.png` });
    await comesTrue(async () => (await at())[1] < 1.0, 'expected the film to begin again');
    const [paused, , duration, width] = await at();
    expect(!paused && duration === 2 && width === 480, `found ${await at()}`);
    const [download] = await Promise.all([page.waitForEvent('download'), page.locator('.files a[href="film.mp4"]').click()]);
    const saved = await readFile(await download.path());
    expect(saved.equals(await readFile(`${apart}/film.mp4`)), 'expected the film to the byte');
    await page.locator('summary').click();
    expect(await page.locator('a[href="pot.svg"]').isVisible(), 'expected the drawing behind the fold');
    await page.screenshot({ path: `${folder}/film.png`, fullPage: true });
    expect(complaints.length === 0, complaints.join('; '));
    await context.close();
    const calm = await opened(browser, own.origin, path, { ...PHONE, reducedMotion: 'reduce' });
    await calm.page.locator('#video').scrollIntoViewIfNeeded();
    await calm.page.waitForTimeout(400 * SLOWNESS);
    expect(await calm.page.$eval('#video', (video) => video.paused), 'expected a film at rest where less motion is wanted');
    await calm.context.close();
    return 'runs in view, begins again, saved to the byte; at rest for less motion';
});

CHECKS['a phone without H.264'] = ({ browser }) => filmed(async (own, path) => {
    const context = await contextOf(browser, PHONE);
    await context.addInitScript(() => { HTMLMediaElement.prototype.canPlayType = () => ''; });
    const page = await context.newPage();
    await page.goto(own.origin + path);
    await page.waitForSelector('.drawn', DRAWN);
    expect(await page.locator('video').count() === 0, 'expected the animated picture in place of the video');
    await page.click('#film');
    await page.waitForSelector('#film.playing img[src$="film.webp"]');
    await context.close();
    return 'the animated picture';
});

CHECKS['sharing, and an iPhone'] = ({ browser }) => filmed(async (own, path) => {
    const context = await contextOf(browser, PHONE);
    await context.addInitScript(() => {
        navigator.canShare = ({ files }) => files.length > 0;
        navigator.share = async ({ files }) => { window.shared = files.map((file) => [file.name, file.type, file.size]); };
    });
    const page = await context.newPage();
    const complaints = watch(page, own.origin);
    await page.goto(own.origin + path);
    await page.click('#share');
    await page.waitForFunction(() => window.shared);
    const shared = await page.evaluate(() => window.shared);
    expect(shared.map(([name]) => name.split('.')[1]).join() === 'png,mp4' && shared[1][1] === 'video/mp4' && shared[1][2] > 1000,
        `found ${JSON.stringify(shared)}`);
    expect(complaints.length === 0, complaints.join('; '));
    await context.close();
    const agent = 'Mozilla/5.0 (iPhone; CPU iPhone OS 17_0 like Mac OS X) AppleWebKit/605.1.15 Version/17.0 Mobile/15E148 Safari/604.1';
    const apple = await opened(browser, own.origin, path, { ...PHONE, userAgent: agent });
    expect(await apple.page.locator('#iphone').isVisible(), 'expected to be told where files go');
    expect(!await apple.page.locator('#share').isVisible(), 'expected no button where files are not shared');
    await apple.context.close();
    return 'picture and film; a hint elsewhere';
});

CHECKS['a code that is none'] = async ({ browser, own, code }) => {
    const context = await contextOf(browser, { ...PHONE, locale: 'ko-KR' });
    const page = await context.newPage();
    const answer = await page.goto(`${own.origin}/7777ZZZZ/`);
    expect(answer.status() === 404, `found ${answer.status()}`);
    expect(await page.getAttribute('html', 'lang') === 'ko', 'expected the phone\'s language first');
    await page.screenshot({ path: `${folder}/lost.png` });
    await page.goto(own.origin);
    await page.screenshot({ path: `${folder}/ask.png` });
    await page.fill('#code', `${code.slice(0, 4).toLowerCase()}-${code.slice(4)}`);
    await page.click('button');
    await page.waitForSelector('.drawn', DRAWN);
    expect(page.url() === `${own.origin}/${code}/`, `found ${page.url()}`);
    await context.close();
    return 'a kind page; a typed code finds its pot';
};

CHECKS['a plain web server'] = async ({ browser, plain, code }) => {
    const { context, page, complaints } = await opened(browser, plain.origin, `/${code}/`, PHONE);
    await expectDrawnPot(browser, page);
    await expectFiles(page, code);
    await page.goto(plain.origin);
    await page.fill('#code', code.toLowerCase());
    await page.click('button');
    await page.waitForSelector('.drawn', DRAWN);
    expect(complaints.length === 0, complaints.join('; '));
    await context.close();
    return 'the same folder, the same page';
};

CHECKS['augmented reality'] = async ({ browser, own }) => {
    const code = await makeOutbox(makeProgram, session, folder, ['--url', 'https://museum.example/pots']);
    const agent = 'Mozilla/5.0 (Linux; Android 14) AppleWebKit/537.36 Chrome/130 Mobile';
    const android = await opened(browser, own.origin, `/${code}/`, { ...PHONE, userAgent: agent });
    const link = android.page.locator('#ar');
    expect(await link.isVisible(), 'expected a button on Android');
    expect((await link.getAttribute('href')).includes(`file=https://museum.example/pots/${code}/pot.glb&`), 'found another link');
    await android.context.close();
    const other = await opened(browser, own.origin, `/${code}/`, PHONE);
    expect(!await other.page.locator('#ar').isVisible(), 'expected none elsewhere');
    await other.context.close();
    return 'Scene Viewer, on Android, behind https';
};

CHECKS['a slow phone'] = async ({ browser, own, code }) => {
    // What a phone shares its machine with makes it slower, and never faster: one load in so many that is quick is enough.
    const LOADS = 5;
    const most_ms = 1000 * SLOWNESS;
    let times;
    let poster;
    for (let load = 0; load < LOADS && !(poster?.[1] < most_ms); load += 1) {
        const context = await contextOf(browser, PHONE);
        const page = await context.newPage();
        const link = await context.newCDPSession(page);
        // What Chromium calls fast 3G: 1.6 Mbit/s, 150 ms there and back.
        await link.send('Network.emulateNetworkConditions', { offline: false, latency: 150, downloadThroughput: 200_000, uploadThroughput: 90_000 });
        await page.goto(`${own.origin}/${code}/`, { waitUntil: 'load' });
        times = await page.evaluate(() => performance.getEntriesByType('resource').concat(performance.getEntriesByType('navigation'))
            .map((entry) => [new URL(entry.name).pathname.split('/').pop() || 'page', Math.round(entry.responseEnd), entry.transferSize]));
        poster = times.find(([name]) => name === 'poster.webp');
        await context.close();
    }
    const bytes = times.reduce((sum, entry) => sum + entry[2], 0);
    expect(poster[1] < most_ms, `expected the poster within ${most_ms} ms, found ${poster[1]} ms`);
    expect(bytes < 150_000, `expected less than 150 kB, found ${bytes}`);
    return `poster after ${poster[1]} ms, ${bytes} bytes until loaded: ${times.map(([name, , size]) => `${name} ${size}`).join(', ')}`;
};

await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
await makeOutbox(makeProgram, session, folder);
const browser = await launch();
const failed = [];
let own;
let plain;
try {
    await makePictures(browser, folder);
    const code = await makeOutbox(makeProgram, session, folder,
        ['poster', 'film', 'surface'].flatMap((name) => [`--${name}`, `${folder}/${name}.webp`]));
    own = await serveByOnggi(onggi, `${folder}/box`);
    plain = await serveByPython(`${folder}/box`);
    for (const [name, check] of Object.entries(CHECKS)) {
        try {
            console.log(`${name}: ${await check({ browser, own, plain, code })}`);
        } catch (problem) {
            failed.push(name);
            console.error(`${name}: FAILED: ${problem.message}`);
        }
    }
} finally {
    await browser.close();
    await own?.stop();
    await plain?.stop();
}
console.log(`${Object.keys(CHECKS).length - failed.length} passed, ${failed.length} failed`);
process.exitCode = failed.length === 0 ? 0 : 1;
