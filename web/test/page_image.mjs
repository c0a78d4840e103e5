// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Writes an image of the page: docs/images/page.png, or the page at other widths to look at.
//   node page_image.mjs FOLDER CHROMIUM FILE.png [WIDTH] [light|dark] [PRESET]
import { writeFileSync } from 'node:fs';

import { Page } from './browser.mjs';

const [folder, chromium, file, width = '1280', scheme = 'light', preset = 'Far plane'] =
  process.argv.slice(2);
const page = await Page.open(chromium, folder, { width: Number(width), height: 900 });
await page.send('Emulation.setEmulatedMedia', {
  features: [{ name: 'prefers-color-scheme', value: scheme }],
});
await page.send('Emulation.setDeviceMetricsOverride', {
  width: Number(width),
  height: 900,
  deviceScaleFactor: 1,
  mobile: Number(width) < 600,
});
await page.loaded('Number(document.documentElement.dataset.shows) > 0');
await page.evaluate(
  `[...document.querySelectorAll('#presets button')].find((button) => button.textContent === '${preset}').click()`,
);
await page.until('document.getElementById("fix").hidden === false');
const { contentSize } = await page.send('Page.getLayoutMetrics');
const { data } = await page.send('Page.captureScreenshot', {
  captureBeyondViewport: true,
  clip: { x: 0, y: 0, width: Number(width), height: contentSize.height, scale: 1 },
});
writeFileSync(file, Buffer.from(data, 'base64'));
await page.close();
