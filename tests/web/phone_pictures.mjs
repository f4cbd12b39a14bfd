// Pictures for a shared pot, made and looked at by the browser itself.
import { readFile, writeFile } from 'node:fs/promises';

/** Draws on a canvas in an empty page and keeps it as WebP: `draw(context, width, height, source)`. */
async function paint(page, file, width, height, draw, source = '') {
    const url = await page.evaluate(async ([body, w, h, from]) => {
        const canvas = Object.assign(document.createElement('canvas'), { width: w, height: h });
        const picture = new Image();
        if (from) { picture.src = from; await picture.decode(); }
        new Function('context', 'width', 'height', 'picture', body)(canvas.getContext('2d'), w, h, picture);
        return canvas.toDataURL('image/webp', 0.8);
    }, [draw, width, height, source]);
    await writeFile(file, Buffer.from(url.split(',')[1], 'base64'));
}

/** What a kiosk would bring: a poster from the pot's picture, a surface with a drawing, a film of one moment. */
export async function makePictures(browser, folder) {
    const page = await browser.newPage();
    const source = async (name) => `data:image/png;base64,${await readFile(`${folder}/${name}`, 'base64')}`;
    await paint(page, `${folder}/poster.webp`, 720, 720, 'context.drawImage(picture, 0, 0)', await source('poster.png'));
    await paint(page, `${folder}/film.webp`, 480, 360, 'context.drawImage(picture, 0, -60, width, width)', await source('pot.png'));
    await paint(page, `${folder}/surface.webp`, 1024, 512, `
        context.fillStyle = '#87a386'; context.fillRect(0, 0, width, height);
        context.strokeStyle = '#e8eadf'; context.lineWidth = 5;
        for (const y of [60, 74, 440, 454]) { context.beginPath(); context.moveTo(0, y); context.lineTo(width, y); context.stroke(); }
        for (let x = 64; x < width; x += 128) {
            context.beginPath(); context.arc(x, 250, 44, 0, 7); context.stroke();
            context.fillStyle = '#3a4a3c'; context.beginPath(); context.arc(x, 250, 14, 0, 7); context.fill();
        }`);
    await page.close();
}

/** Of each row of a PNG that shows something else than its first pixel, the first and the last such pixel. */
export async function silhouette(browser, png) {
    const page = await browser.newPage();
    const rows = await page.evaluate(async (url) => {
        const picture = new Image();
        picture.src = url;
        await picture.decode();
        const canvas = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
        const context = canvas.getContext('2d');
        context.drawImage(picture, 0, 0);
        const { data } = context.getImageData(0, 0, picture.width, picture.height);
        // Half covered: as far from the ground as a pot's pixel may be near to it.
        const shows = (at) => [0, 1, 2].reduce((sum, c) => sum + Math.abs(data[at + c] - data[c]), 0) > 190;
        return Array.from({ length: picture.height }, (_, y) => {
            const found = [];
            for (let x = 0; x < picture.width; x += 1) if (shows(4 * (y * picture.width + x))) found.push(x);
            return found.length ? [found[0], found[found.length - 1]] : null;
        });
    }, `data:image/png;base64,${png.toString('base64')}`);
    await page.close();
    return rows;
}

/** How a PNG looks: the share of its pixels that another lacks, and their mean; each 0 to 1. */
export async function difference(browser, one, other) {
    const page = await browser.newPage();
    const found = await page.evaluate(async (pngs) => {
        const pixels = [];
        for (const png of pngs) {
            const picture = new Image();
            picture.src = `data:image/png;base64,${png}`;
            await picture.decode();
            const canvas = Object.assign(document.createElement('canvas'), { width: picture.width, height: picture.height });
            const context = canvas.getContext('2d');
            context.drawImage(picture, 0, 0);
            pixels.push(context.getImageData(0, 0, picture.width, picture.height).data);
        }
        let other = 0;
        for (let i = 0; i < pixels[0].length; i += 4) {
            const far = [0, 1, 2].some((c) => Math.abs(pixels[0][i + c] - pixels[1][i + c]) > 12);
            other += far ? 1 : 0;
        }
        return other / (pixels[0].length / 4);
    }, [one.toString('base64'), other.toString('base64')]);
    await page.close();
    return found;
}
