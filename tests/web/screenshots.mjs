// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Pictures of every view for people to look at, in the build folder.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';

import { drawAll, openPage, openScenes } from './browser.mjs';

const SECTIONS = ['summary', 'table', 'comparison', 'figures', 'scenes', 'missing', 'glossary', 'origin'];

async function shoot(browser, file, folder, width, colorScheme) {
  const name = `${width > 600 ? 'wide' : 'narrow'}-${colorScheme}`;
  const { page, close } = await openPage(browser, file, { viewport: { width, height: 900 }, colorScheme });
  await drawAll(page);
  if (await page.locator('#scene-view select').count() > 0 || await page.locator('#scene-view').count() > 0) {
    await openScenes(page);
    await page.waitForTimeout(500);
  }
  for (const section of SECTIONS) {
    const part = page.locator(`#${section}`);
    if (await part.count() > 0) await part.screenshot({ path: join(folder, `${section}-${name}.png`) });
  }
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.screenshot({ path: join(folder, `top-${name}.png`) });
  await page.locator('button.cell').nth(2).click();
  await page.locator('#cell-dialog').waitFor();
  await page.screenshot({ path: join(folder, `cell-${name}.png`) });
  await close();
}

export async function takeScreenshots(browser, file, folder) {
  mkdirSync(folder, { recursive: true });
  for (const width of [1280, 360]) {
    for (const colorScheme of ['light', 'dark']) await shoot(browser, file, folder, width, colorScheme);
  }
}
