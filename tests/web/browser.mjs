// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { createRequire } from 'node:module';
import { join } from 'node:path';

// As a user's browser, but without anything that it would do on its own account.
const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync'];
const GL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const NO_GL = ['--disable-gpu', '--disable-3d-apis'];
// A page that does nothing for so long has stopped; on a busy machine one may take a minute to load.
const PATIENCE_MS = 200_000;

export function launcher(modules, chromium) {
  const { chromium: driver } = createRequire(join(modules, 'x.js'))('playwright-core');
  return (webgl = true) => driver.launch({
    executablePath: chromium, args: [...FLAGS, ...(webgl ? GL : NO_GL)],
  });
}

// What of it a page must not do is in `faults`: errors in the console, requests but for itself.
export async function openPage(browser, file, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  context.setDefaultTimeout(PATIENCE_MS);
  const page = await context.newPage();
  const faults = [];
  page.on('console', (message) => {
    // Plotly warns of a layout that it does not take as it is.
    if (message.type() === 'error' || /WARN: ignored/.test(message.text())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('dialog', (dialog) => { faults.push(`dialog ${dialog.message()}`); dialog.dismiss(); });
  page.on('request', (request) => {
    const url = request.url();
    if (!/^(data|blob):/.test(url) && url !== `file://${file}`) faults.push(`request ${url}`);
  });
  await page.goto(`file://${file}`);
  return { page, faults, close: () => context.close() };
}

export async function openScenes(page) {
  await page.locator('#scene-view').scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.getElementById('scene-view').dataset.frame !== undefined);
}

export async function drawAll(page) {
  for (const figure of await page.locator('[data-figure]').all()) {
    await figure.scrollIntoViewIfNeeded();
    await figure.and(page.locator('[data-drawn]')).waitFor();
  }
}
