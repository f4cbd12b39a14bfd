// What a page must keep for everybody to use it. Each rule runs inside the page and gives what breaks it.

/** Pictures, links and buttons have names; there is one h1, a main part and a title. */
export function unnamed() {
    const broken = [];
    for (const item of document.querySelectorAll('a, button, canvas, [role=img]')) {
        if (item.offsetParent === null) continue;
        const name = item.getAttribute('aria-label') || item.innerText.trim() || item.title;
        if (!name) broken.push(`no name: ${item.outerHTML.slice(0, 80)}`);
    }
    for (const picture of document.images) if (!picture.hasAttribute('alt')) broken.push(`no alt: ${picture.src}`);
    if (document.querySelectorAll('h1').length !== 1 || !document.querySelector('main') || !document.title) {
        broken.push('one h1, one main, one title');
    }
    return broken;
}

/** What is touched is 44 px at least; no letters are under 15 px. */
export function tooSmall() {
    const broken = [];
    for (const target of document.querySelectorAll('a, button')) {
        if (target.offsetParent === null) continue;
        const box = target.getBoundingClientRect();
        if (box.width < 44 || box.height < 44) broken.push(`${Math.round(box.width)} x ${Math.round(box.height)}: ${target.innerText}`);
    }
    for (const item of document.body.querySelectorAll('*')) {
        const own = [...item.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
        if (own && parseFloat(getComputedStyle(item).fontSize) < 15) broken.push(`small letters: ${item.innerText}`);
    }
    return broken;
}

/** Letters stand out from what is behind them, 4.5 to 1 (WCAG 2.1, 1.4.3), against each colour of a gradient too. */
export function tooFaint() {
    const broken = [];
    const colours = (text) => (text.match(/rgba?\([^)]*\)/g) || []).map((colour) => colour.match(/[\d.]+/g).map(Number))
        .filter((colour) => colour.length < 4 || colour[3] > 0.8);
    const luminance = ([r, g, b]) => [r, g, b].map((c) => c / 255)
        .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)).reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
    for (const item of document.body.querySelectorAll('*')) {
        const own = [...item.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
        if (!own || item.offsetParent === null || ['SCRIPT', 'STYLE'].includes(item.tagName)) continue;
        let behind = [];
        for (let place = item; place && behind.length === 0; place = place.parentElement) {
            const style = getComputedStyle(place);
            behind = colours(style.backgroundImage).concat(colours(style.backgroundColor));
        }
        const ink = luminance(colours(getComputedStyle(item).color)[0]);
        for (const colour of behind) {
            const ground = luminance(colour);
            const ratio = (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05);
            if (ratio < 4.5) broken.push(`${ratio.toFixed(1)}: ${item.innerText.slice(0, 40)}`);
        }
    }
    return broken;
}
