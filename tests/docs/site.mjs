// Looks at the documentation site (make docs) in headless Chromium, on a wide and on a narrow screen:
//
//     node tests/docs/site.mjs out/site [PICTURES]
//
// No page asks another host for anything, reports an error, shows a broken picture, or is wider than the screen; the
// search finds pages. PICTURES: a folder for screenshots of every page.

import { readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { serverOf } from '../../web/serve.js';

const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
const { chromium } = createRequire(join(root, 'web/package.json'))('playwright-core');
const [site, pictures] = process.argv.slice(2);
const pages = readdirSync(site, { recursive: true }).filter((name) => name.endsWith('.html') && name !== '404.html').sort();

const server = serverOf(site);
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
const origin = `http://127.0.0.1:${server.address().port}`;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-gpu'],
});
const wrong = [];
for (const width of [1280, 400]) {
  const page = await browser.newPage({ viewport: { width, height: 800 } });
  page.setDefaultTimeout(120_000);
  let name = '';
  const report = (text) => wrong.push(`${name} at ${width}: ${text}`);
  page.on('request', (request) => {
    if (!/^(blob:|data:)/.test(request.url()) && new URL(request.url()).origin !== origin) report(`asks for ${request.url()}`);
  });
  page.on('pageerror', (error) => report(error.message));
  page.on('console', (message) => message.type() === 'error' && report(message.text()));
  for (name of pages) {
    await page.goto(`${origin}/${name}`);
    const found = await page.evaluate(() => ({
      wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
      broken: [...document.images].filter((image) => image.complete && image.naturalWidth === 0).map((image) => image.src),
    }));
    if (found.wide > 0) report(`${found.wide} pixels wider than the screen`);
    found.broken.forEach((source) => report(`broken picture ${source}`));
    if (pictures) await page.screenshot({ path: join(pictures, `${name.replaceAll('/', '-')}-${width}.png`) });
  }
  name = 'search';
  await page.goto(`${origin}/index.html`);
  if (width < 1000) await page.click('label[for=__search].md-header__button');
  await page.fill('.md-search__input', 'refraction');
  await page.waitForSelector('.md-search-result__item');
  if (pictures) await page.screenshot({ path: join(pictures, `search-${width}.png`) });
  await page.close();
}
await browser.close();
server.close();
console.log([...wrong, `${pages.length} pages at two widths, ${wrong.length} wrong`].join('\n'));
process.exit(wrong.length === 0 && pages.length > 0 ? 0 : 1);
