// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import assert from 'node:assert/strict';

const values = '[data-table="table"] table.cvo-values';

function columnOf(page, metric) {
  return page.locator(`${values} tbody tr.ours td[data-column]`).evaluateAll((cells, name) => {
    const table = cells[0].closest('table');
    const column = table.querySelector(`th[data-metric="${name}"]`).dataset.column;
    return cells.filter((cell) => cell.dataset.column === column && !cell.closest('tr').hidden)
      .map((cell) => (cell.dataset.value === undefined ? null : Number(cell.dataset.value)));
  }, metric);
}

const sorted = (list, sign) => {
  const numbers = list.filter((value) => value !== null).sort((a, b) => sign * (a - b));
  return [...numbers, ...list.filter((value) => value === null)];
};

export const tableTests = {
  async 'a heading sorts up, down and back, cells without a value last'({ good }) {
    const before = await columnOf(good.page, 'moving_precision');
    assert.ok(before.includes(null), 'static says of nothing that it moves');
    assert.notDeepEqual(before, sorted(before, 1), 'or this test could not fail');
    const heading = good.page.locator(`${values} th[data-metric="moving_precision"]`);
    for (const [direction, expected] of [['ascending', sorted(before, 1)], ['descending', sorted(before, -1)], ['none', before]]) {
      await heading.locator('button').click();
      assert.equal(await heading.getAttribute('aria-sort'), direction);
      assert.deepEqual(await columnOf(good.page, 'moving_precision'), expected);
    }
  },

  async 'sorting by keyboard'({ good }) {
    const heading = good.page.locator(`${values} th[data-metric="camera_ate"]`);
    await heading.locator('button').focus();
    await good.page.keyboard.press('Enter');
    assert.equal(await heading.getAttribute('aria-sort'), 'ascending');
    const now = await columnOf(good.page, 'camera_ate');
    assert.deepEqual(now, sorted(now, 1));
    await good.page.keyboard.press('Enter');
    await good.page.keyboard.press('Enter');
  },

  async 'the filter keeps rows with all words'({ good }) {
    const field = good.page.locator('.filter input').first();
    await field.fill('short 2d');
    const shown = await good.page.locator(`${values} tbody tr.ours:visible th`).allTextContents();
    assert.deepEqual(shown, ['short', '2d']);
    assert.equal(await good.page.locator('.filter .said').first().textContent(), '1 of 6 rows');
    await field.fill('');
    assert.equal(await good.page.locator(`${values} tbody tr.ours:visible`).count(), 6);
  },

  async 'a column can be hidden and shown'({ good }) {
    const cells = good.page.locator(`${values} [data-metric="camera_ate"], ${values} td[data-column="1"]`);
    const count = await cells.and(good.page.locator(':visible')).count();
    await good.page.locator('.columns summary').first().click();
    const box = good.page.locator('.columns').first().getByLabel(/camera ATE/);
    await box.uncheck();
    assert.equal(await cells.and(good.page.locator(':visible')).count(), 0);
    await box.check();
    assert.equal(await cells.and(good.page.locator(':visible')).count(), count);
    await good.page.locator('.columns summary').first().click();
  },

  async 'a cell opens its provenance, Escape closes it and the focus is back'({ good }) {
    const cell = good.page.locator(`${values} tr[data-row="1"] td[data-column="1"] button`);
    await cell.click();
    const dialog = good.page.locator('#cell-dialog');
    await dialog.waitFor();
    const text = await dialog.textContent();
    for (const part of ['tiny 2d: camera ATE', 'tiny, seed 1: ok', 'tiny, seed 2: ok', '/result.json', 'commit', 'compiler', 'host', 'Difference']) {
      assert.ok(text.includes(part), `${part} in ${text}`);
    }
    assert.ok(await dialog.evaluate((element) => element.contains(document.activeElement)));
    await good.page.keyboard.press('Escape');
    assert.equal(await dialog.isVisible(), false);
    assert.ok(await cell.evaluate((element) => element === document.activeElement));
  },

  async 'the table is one stop of the Tab key, arrows move within'({ good }) {
    const at = () => good.page.evaluate(() => {
      const { row, column } = document.activeElement.closest('td').dataset;
      return `${row} ${column}`;
    });
    await good.page.locator(`${values} button.cell`).first().focus();
    assert.equal(await at(), '0 0');
    await good.page.keyboard.press('ArrowRight');
    await good.page.keyboard.press('ArrowDown');
    assert.equal(await at(), '1 1');
    await good.page.keyboard.press('Home');
    assert.equal(await at(), '1 0');
    await good.page.keyboard.press('Enter');
    await good.page.locator('#cell-dialog').waitFor();
    await good.page.keyboard.press('Escape');
    assert.equal(await at(), '1 0');
    assert.equal(await good.page.locator(`${values} button.cell[tabindex="0"]`).count(), 1);
  },

  async 'the comparison has a table with provenance of its own'({ good }) {
    await good.page.locator('[data-table="comparison"] button.cell').first().click();
    await good.page.locator('#cell-dialog').waitFor();
    await good.page.locator('#cell-dialog .close').click();
    assert.equal(await good.page.locator('#cell-dialog').isVisible(), false);
  },
};
