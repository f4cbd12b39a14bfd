// Debian's Chromium, and what a page in it must not do. Shared by the checks that open pages.
import { chromium } from 'playwright-core';

const BROWSER = process.env.ONGGI_CHROMIUM ?? '/usr/bin/chromium';
const FLAGS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
    '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];

/** How many times slower this machine is than the reference machine (tests/support/patience.h). */
export const SLOWNESS = Math.max(1, Number(process.env.ONGGI_SLOWNESS ?? 1));

/** For whatever a page waits for: four times Playwright's own half minute, because a busy machine keeps a page waiting. */
export const PATIENCE = { timeout: 120_000 * SLOWNESS };

export const launch = (more = []) => chromium.launch({ executablePath: BROWSER, args: [...FLAGS, ...more] });

export function expect(holds, words) {
    if (!holds) throw new Error(words);
}

/** Collects every console error, failed request, and request to another host. */
export function watch(page, origin) {
    const complaints = [];
    page.on('console', (message) => { if (message.type() === 'error') complaints.push(`console: ${message.text()}`); });
    page.on('pageerror', (problem) => complaints.push(`page: ${problem.message}`));
    page.on('requestfailed', (request) => complaints.push(`request: ${request.url()} ${request.failure()?.errorText}`));
    page.on('request', (request) => {
        if (!/^(data|blob):/.test(request.url()) && new URL(request.url()).origin !== origin) {
            complaints.push(`off-site: ${request.url()}`);
        }
    });
    return complaints;
}
