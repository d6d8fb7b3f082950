// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';

import { drawAll, openPage, openScenes } from './browser.mjs';
import { BREAKOUT, HOSTILE } from './suite.mjs';

// Relative luminance contrast of WCAG 2, of every text against what is painted behind it.
function poorContrast() {
  const numbers = (colour) => colour.match(/[\d.]+/g).map(Number);
  const luminance = (colour) => {
    const [r, g, b] = numbers(colour).map((value) => {
      const c = value / 255;
      return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const painted = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const colour = getComputedStyle(at).backgroundColor;
      if (/^rgb\(/.test(colour)) return colour;
    }
    return 'rgb(255, 255, 255)';
  };
  const poor = [];
  for (const element of document.querySelectorAll('body *:not(.plot *):not(script)')) {
    const text = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
    if (!text || !element.checkVisibility()) continue;
    const a = luminance(getComputedStyle(element).color);
    const b = luminance(painted(element));
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) poor.push(`${element.tagName}.${element.className} ${contrast.toFixed(2)}`);
  }
  return [...new Set(poor)];
}

const tooWide = () => {
  const width = document.documentElement.clientWidth;
  return document.documentElement.scrollWidth > width ? document.documentElement.scrollWidth - width : 0;
};

export const pageTests = {
  async 'the page says what was compared, on what, and what of it is significant'({ good }) {
    const text = await good.page.locator('#summary').innerText();
    for (const part of ['Compares 3 variants (full, 2d and static) on 2 sequences (tiny and short)', 'each with 2 seeds', '12 of 12 runs are complete', 'Significant differences', 'labels from the 2D boxes only']) {
      assert.ok(text.includes(part), part);
    }
  },

  async 'every figure is drawn, and has its text alternative'({ good }) {
    await drawAll(good.page);
    const figures = await good.page.locator('[data-figure]').evaluateAll((all) => all.map((figure) => ({
      drawn: figure.querySelector('.main-svg') !== null,
      label: figure.querySelector('.plot').getAttribute('aria-label').length,
      words: figure.querySelector('details p').textContent.length,
    })));
    assert.ok(figures.length > 0);
    for (const figure of figures) {
      assert.ok(figure.drawn && figure.label > 40 && figure.words > 40, JSON.stringify(figure));
    }
  },

  async 'no button of a chart sends it anywhere'({ good }) {
    await drawAll(good.page);
    const names = await good.page.locator('.modebar-btn').evaluateAll((all) => all.map((button) => button.dataset.title ?? button.dataset.attr ?? ''));
    assert.ok(names.length > 0);
    assert.deepEqual(names.filter((name) => /share|cloud|send|edit/i.test(name)), []);
  },

  async 'what the page names is in it: labels of images and of fields'({ good }) {
    const unnamed = await good.page.evaluate(() => [
      ...[...document.querySelectorAll('img:not([hidden])')].filter((image) => !image.alt),
      ...[...document.querySelectorAll('input, select')].filter((field) => !field.labels?.length && !field.ariaLabel),
      ...[...document.querySelectorAll('button')].filter((button) => !button.textContent.trim() && !button.ariaLabel),
    ].map((element) => element.outerHTML.slice(0, 120)));
    assert.deepEqual(unnamed, []);
  },

  async 'hostile names stay text, and what is missing is said'({ pages, browser }) {
    const { page, faults, close } = await openPage(browser, pages.bad);
    await drawAll(page);
    await openScenes(page);
    for (const cell of await page.locator('button.cell').all()) {
      await cell.click();
      await page.keyboard.press('Escape');
    }
    assert.equal(await page.evaluate(() => window.hacked), undefined);
    assert.equal(await page.locator('img[src="x"]').count(), 0);
    assert.deepEqual(faults, []);
    assert.ok((await page.title()).startsWith(HOSTILE));
    const text = await page.locator('main').innerText();
    assert.ok(text.includes(BREAKOUT) && text.includes(HOSTILE));
    assert.match(text, /9 of 12 runs are complete; 3 failed/);
    assert.match(await page.locator('#missing').innerText(), /schema_version/);
    await close();
  },

  async 'the menu has the names of the headings'({ good }) {
    const names = await good.page.evaluate(() => [...document.querySelectorAll('header nav a')].map((link) => [
      link.textContent, document.querySelector(`${link.getAttribute('href')} h2`).textContent]));
    assert.ok(names.length > 5);
    for (const [name, heading] of names) assert.equal(name, heading);
  },

  async 'what goes on to the side says so, until its end'({ pages, browser }) {
    const { page, close } = await openPage(browser, pages.good, { viewport: { width: 390, height: 844 } });
    const table = page.locator('.cvo-scroll').first();
    const hint = page.locator('.cvo-scroll + .scroll-hint').first();
    await hint.waitFor();
    const fades = () => table.evaluate((place) => place.classList.contains('more-right'));
    assert.ok(await fades());
    await table.evaluate((place) => { place.scrollLeft = place.scrollWidth; });
    await page.waitForFunction(() => !document.querySelector('.cvo-scroll').classList.contains('more-right'));
    const caption = await page.locator('.cvo-differences .cvo-caption').first().boundingBox();
    assert.ok(caption.width <= 390, 'captions wrap');
    await close();
  },

  async 'maps are as high as their width needs'({ good }) {
    await drawAll(good.page);
    const gaps = await good.page.evaluate(() => [...document.querySelectorAll('[data-figure] .plot')]
      .filter((plot) => plot.layout.yaxis?.scaleanchor)
      .map((plot) => {
        const size = plot._fullLayout._size;
        const [low, high] = plot._fullLayout.yaxis.domain;
        const whole = plot.layout.yaxis.domain;
        return 1 - (high - low) / (whole[1] - whole[0]) + 0 * size.h;
      }));
    assert.ok(gaps.length > 0);
    for (const gap of gaps) assert.ok(gap < 0.2, `${gap} of the height is empty`);
  },

  async 'a phone scrolls down only'({ pages, browser }) {
    const { page, faults, close } = await openPage(browser, pages.good, { viewport: { width: 360, height: 740 }, hasTouch: true });
    assert.equal(await page.evaluate(tooWide), 0);
    await drawAll(page);
    await openScenes(page);
    assert.equal(await page.evaluate(tooWide), 0);
    assert.deepEqual(faults, []);
    await close();
  },

  async 'text is readable in light and dark'({ pages, browser }) {
    for (const colorScheme of ['light', 'dark']) {
      const { page, close } = await openPage(browser, pages.good, { colorScheme });
      await openScenes(page);
      assert.deepEqual(await page.evaluate(poorContrast), [], colorScheme);
      const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      assert.equal(back, colorScheme === 'light' ? 'rgb(255, 255, 255)' : 'rgb(21, 23, 27)');
      await close();
    }
  },

  async 'figures follow a change of the scheme'({ pages, browser }) {
    const { page, close } = await openPage(browser, pages.good);
    await drawAll(page);
    const ink = () => page.evaluate(() => document.querySelector('[data-figure] .plot')._fullLayout.font.color);
    const light = await ink();
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.waitForFunction((before) => document.querySelector('[data-figure] .plot')._fullLayout.font.color !== before, light);
    await close();
  },

  async 'it can be used at once'({ pages, browser }) {
    const { page, close } = await openPage(browser, pages.good);
    const times = await page.evaluate(() => {
      const [entry] = performance.getEntriesByType('navigation');
      return { usable: Number(document.documentElement.dataset.ready), loaded: entry.loadEventEnd };
    });
    console.log(`# usable after ${times.usable} ms, all read after ${Math.round(times.loaded)} ms`);
    assert.ok(times.usable < times.loaded, 'the page can be used before Plotly is read');
    await close();
  },

  async 'nothing went wrong on the way'({ good }) {
    assert.deepEqual(good.faults, []);
  },
};
