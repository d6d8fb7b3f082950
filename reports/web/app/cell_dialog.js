// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { element, facts } from './element.js';

// The jobs of a row whose result is not in the cell.
function otherRuns(row, table, used, data) {
  return data.runs.filter((run) => !used.has(run.result) &&
    table.keys.every((key, i) => (run.keys[key] ?? 'none') === row.keys[i] || (run.keys[key] === undefined && row.keys[i] === 'default')));
}

function runItem(run, data) {
  const options = data.options[run.options];
  return element('li', {},
    element('strong', {}, `${run.keys.sequence ?? ''}, seed ${run.seed}: ${run.state}`),
    run.message ? ` – ${run.message}` : null,
    facts([
      ['result', run.result || 'none'],
      ...(run.log ? [['log', run.log]] : []),
      ...run.time,
      ...options.map(([path, value, usual]) => [path, usual ? `${value} (default ${usual})` : value]),
    ]));
}

function runList(heading, runs, data) {
  if (runs.length === 0) return null;
  return element('details', { open: runs.length <= 6 },
    element('summary', {}, `${heading}: ${runs.length}`),
    element('ul', { class: 'runs' }, runs.map((run) => runItem(run, data))));
}

function shared(heading, runs, key, list) {
  const sets = [...new Set(runs.map((run) => run[key]))].map((index) => list[index]).filter((pairs) => pairs.length > 0);
  return [element('h3', {}, heading), sets.length === 0 ? element('p', {}, 'Not known.') : sets.map(facts)];
}

function content(row, column, cell, table, data) {
  const results = new Set(cell.runs.map((index) => row.results[index]));
  const used = data.runs.filter((run) => results.has(run.result));
  return [
    facts(cell.facts),
    cell.difference ? [element('h3', {}, 'Difference'), facts(cell.difference)] : null,
    element('h3', {}, 'Runs behind it'),
    runList('In this value', used, data),
    runList('Of this row, but not in this value', otherRuns(row, table, results, data), data),
    used.length > 0 ? [...shared('Program', used, 'build', data.builds), ...shared('Machine', used, 'machine', data.machines)] : null,
    element('p', {}, element('a', { href: `#measure-${column.metric}` }, `What ${column.label} means`)),
  ].flat(3).filter(Boolean);
}

function makeDialog() {
  const title = element('h2', { id: 'cell-title', tabindex: '-1', autofocus: true });
  const close = element('button', { type: 'button', class: 'close' }, 'Close');
  const body = element('div', { class: 'dialog-body' });
  const dialog = element('dialog', { id: 'cell-dialog', 'aria-labelledby': 'cell-title' },
    element('div', { class: 'dialog-head' }, title, close), body);
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog || event.target.closest('a')) dialog.close();
  });
  document.body.append(dialog);
  return { dialog, title, body };
}

let parts = null;

function open(row, column, cell, table, data) {
  parts ??= makeDialog();
  parts.title.textContent = `${row.label}: ${column.label}`;
  parts.body.replaceChildren(...content(row, column, cell, table, data));
  parts.body.scrollTop = 0;
  parts.dialog.showModal(); // takes the focus, gives it back, closes on Escape
}

// Each cell of a value becomes a button that says where it comes from.
export function openableCells(table, tableData, data) {
  if (!tableData) return;
  for (const td of table.querySelectorAll('td[data-row][data-column]:not([data-reference])')) {
    const row = tableData.rows[Number(td.dataset.row)];
    const column = tableData.columns[Number(td.dataset.column)];
    const cell = row?.cells[Number(td.dataset.column)];
    if (!cell || !column || td.childNodes.length === 0) continue;
    const button = element('button', { type: 'button', class: 'cell', 'aria-haspopup': 'dialog' });
    button.append(...td.childNodes);
    td.append(button);
    button.addEventListener('click', () => open(row, column, cell, tableData, data));
  }
}
