// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { element } from '../element.js';
import { headings, rowGroups } from './row_groups.js';
import { sortable } from './sort.js';

const narrow = window.matchMedia('(max-width: 48rem)');

function filterField(table) {
  const input = element('input', { type: 'search', placeholder: 'e.g. full', autocomplete: 'off' });
  const said = element('span', { class: 'said', role: 'status' });
  const bodies = [...table.tBodies].map((body) => (body.groups ??= rowGroups(body)));
  input.addEventListener('input', () => {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const group of bodies.flat()) {
      const text = group.rows.map((row) => row.textContent).join(' ').toLowerCase();
      const keep = words.every((word) => text.includes(word));
      shown += keep ? 1 : 0;
      for (const row of group.rows) row.hidden = !keep;
    }
    said.textContent = words.length === 0 ? '' : `${shown} of ${bodies.flat().length} rows`;
  });
  return element('label', { class: 'filter' }, 'Show rows with ', input, said);
}

function showColumn(table, index, shown) {
  const lines = [table.tHead.rows[table.tHead.rows.length - 1], ...[...table.tBodies].flatMap((body) => [...body.rows])];
  for (const row of lines) {
    // A line of one wide cell has no columns.
    const cell = row.cells.length > 1 ? row.cells[index] : null;
    if (cell) cell.hidden = !shown;
  }
}

// On a phone only what names rows is there from the start, of the columns without a number.
function isSecondary(table, heading) {
  const cell = table.tBodies[0]?.rows[0]?.cells[heading.cellIndex];
  return cell?.tagName === 'TD' && !heading.matches('.number');
}

function columnChoice(table, columns) {
  const boxes = columns.map((heading) => {
    const box = element('input', { type: 'checkbox', checked: true });
    box.addEventListener('change', () => showColumn(table, heading.cellIndex, box.checked));
    if (narrow.matches && isSecondary(table, heading)) {
      box.checked = false;
      showColumn(table, heading.cellIndex, false);
    }
    return element('label', {}, box, ' ', heading.textContent.trim());
  });
  return element('details', { class: 'columns' }, element('summary', {}, 'Columns'),
    element('div', { class: 'choices' }, boxes));
}

// A table that can be sorted, filtered and narrowed.
export function tableTools(table) {
  const tools = element('div', { class: 'tools' }, filterField(table),
    columnChoice(table, headings(table)));
  table.parentElement.before(tools);
  sortable(table);
}
