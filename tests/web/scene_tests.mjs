// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';

import { openPage, openScenes } from './browser.mjs';

const frameOf = (page) => page.locator('#scene-view').getAttribute('data-frame');

// The camera's last position as drawn, and the frame of the image beside it.
function seen(page) {
  return page.evaluate(() => {
    const camera = document.querySelector('.scene-plot').data.find((trace) => trace.name === 'camera now');
    const image = document.querySelector('.frame-image');
    return {
      type: camera.type, at: [camera.x[0], camera.y[0]], image: image.dataset.frame, src: image.src,
      cursor: document.querySelector('.error-plot').layout.shapes[0].x0,
      words: document.querySelector('.words').textContent,
      label: document.querySelector('.scene-plot').getAttribute('aria-label'),
    };
  });
}

async function at(page, frame) {
  await page.waitForFunction((wanted) => document.getElementById('scene-view').dataset.frame === wanted, frame);
  return seen(page);
}

export const sceneTests = {
  async 'the slider moves 3D view, image, errors and words together'({ good }) {
    await openScenes(good.page);
    const slider = good.page.locator('.player input');
    await slider.focus();
    await good.page.keyboard.press('Home');
    const first = await at(good.page, '0');
    assert.equal(first.type, 'scatter3d');
    assert.equal(first.image, '0');
    await good.page.keyboard.press('ArrowRight');
    await good.page.keyboard.press('ArrowRight');
    const third = await at(good.page, '2');
    assert.equal(third.image, '2');
    assert.notEqual(third.src, first.src);
    assert.notDeepEqual(third.at, first.at);
    assert.ok(third.cursor > first.cursor);
    assert.notEqual(third.words, first.words);
    assert.match(third.label, /frame 2/);
    assert.match(await slider.getAttribute('aria-valuetext'), /frame 2 \(3 of 6\)/);
    assert.ok(await good.page.locator('.frame-image').first().evaluate((image) => image.naturalWidth > 0 && image.naturalWidth <= 320));
  },

  async 'the axes hold every box whole'({ good }) {
    await openScenes(good.page);
    const outside = await good.page.evaluate(() => {
      const plot = document.querySelector('.scene-plot');
      const { scene } = plot._fullLayout;
      const boxes = plot.data.filter((trace) => trace.mode === 'lines' && !trace.name);
      const points = (axis) => boxes.flatMap((trace) => trace[axis]).filter((value) => value !== null);
      return ['x', 'y', 'z'].map((axis) => {
        const [low, high] = scene[`${axis}axis`].range;
        return { count: points(axis).length, out: points(axis).filter((value) => value < low || value > high).length };
      });
    });
    for (const { count, out } of outside) assert.ok(count > 0 && out === 0, JSON.stringify(outside));
  },

  async 'it plays to the end and stops, and pauses'({ good }) {
    await openScenes(good.page);
    await good.page.locator('.player input').focus();
    await good.page.keyboard.press('Home');
    await at(good.page, '0');
    const play = good.page.locator('.play');
    await play.click();
    assert.equal(await play.textContent(), 'Pause');
    await at(good.page, '5');
    await good.page.waitForFunction(() => document.querySelector('.play').textContent === 'Play');
    await play.click();
    await play.click();
    assert.equal(await play.textContent(), 'Play');
  },

  async 'another run, and from above'({ good }) {
    await openScenes(good.page);
    await good.page.locator('#scene-view select').first().selectOption({ label: 'tiny, 2d, seed 1' });
    assert.match(await good.page.locator('.frame figcaption').first().textContent(), /one estimator per sequence/);
    await good.page.getByLabel('from above (2D)').check();
    assert.equal((await seen(good.page)).type, 'scatter');
    await good.page.getByLabel('from above (2D)').uncheck();
    await good.page.locator('#scene-view select').first().selectOption({ index: 0 });
    assert.equal((await seen(good.page)).type, 'scatter3d');
  },

  async 'without WebGL the run is shown from above, and that is said'({ pages, launch }) {
    const browser = await launch(false);
    const opened = await openPage(browser, pages.good);
    await openScenes(opened.page);
    assert.match(await opened.page.locator('#scene-view .note').textContent(), /no WebGL/);
    assert.equal((await seen(opened.page)).type, 'scatter');
    await opened.page.locator('.player input').focus();
    await opened.page.keyboard.press('End');
    await at(opened.page, '5');
    assert.deepEqual(opened.faults, []);
    await browser.close();
  },

  async 'every frame of the run lies beside the page'({ good, pages }) {
    const folder = await good.page.locator('.all-frames a').getAttribute('href');
    const names = readdirSync(join(dirname(pages.good), folder));
    assert.deepEqual(names.sort(), [0, 1, 2, 3, 4, 5].map((frame) => `00000${frame}.jpg`));
  },

  async 'the frame is kept in the page'({ good }) {
    assert.match(await frameOf(good.page), /^\d+$/);
  },
};
