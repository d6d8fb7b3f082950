// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// node run.mjs PROGRAM NODE_MODULES CHROMIUM OUT [FILTER]: opens report pages in a browser.
import { join, resolve } from 'node:path';

import { launcher, openPage } from './browser.mjs';
import { pageTests } from './page_tests.mjs';
import { sceneTests } from './scene_tests.mjs';
import { takeScreenshots } from './screenshots.mjs';
import { makePages } from './suite.mjs';
import { tableTests } from './table_tests.mjs';

const [program, modules, chromium, out, filter = ''] = process.argv.slice(2).map((path, i) => (i < 4 ? resolve(path) : path));
const pages = makePages(program, out);
const launch = launcher(modules, chromium);
const browser = await launch();
const good = await openPage(browser, pages.good);

const tests = {
  ...tableTests,
  ...sceneTests,
  ...pageTests,
  'screenshots of every view': () => takeScreenshots(browser, pages.good, join(out, 'screenshots')),
};
let failed = 0;
for (const [name, test] of Object.entries(tests)) {
  if (!name.includes(filter)) continue;
  const start = performance.now();
  try {
    await test({ pages, browser, launch, good });
    console.log(`ok      ${name} (${Math.round(performance.now() - start)} ms)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}
await browser.close();
console.log(failed === 0 ? 'all passed' : `${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;
