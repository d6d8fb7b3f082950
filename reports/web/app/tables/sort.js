// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { headings, rowGroups } from './row_groups.js';

const NEXT = { none: 'ascending', ascending: 'descending', descending: 'none' };

function keyOf(group, column) {
  const cell = group.rows[0].cells[column];
  if (!cell) return { empty: true };
  const value = cell.dataset.value;
  if (value !== undefined && value !== '') return { number: Number(value) };
  const text = cell.textContent.trim();
  return { text, empty: text === '' || text === '-' || text === '–' };
}

// What has no value comes last, whatever the direction.
function compare(a, b, sign) {
  if (a.empty || b.empty) return Number(a.empty ?? false) - Number(b.empty ?? false);
  if (a.number !== undefined && b.number !== undefined) return sign * (a.number - b.number);
  if (a.number !== undefined || b.number !== undefined) return a.number !== undefined ? -1 : 1;
  return sign * a.text.localeCompare(b.text, 'en', { numeric: true });
}

function sortBody(body, column, direction) {
  body.groups ??= rowGroups(body);
  const groups = [...body.groups];
  if (direction !== 'none') {
    const sign = direction === 'ascending' ? 1 : -1;
    const keys = new Map(groups.map((group) => [group, keyOf(group, column)]));
    groups.sort((a, b) => compare(keys.get(a), keys.get(b), sign) || a.order - b.order);
  }
  body.append(...groups.flatMap((group) => group.rows));
}

// Headings become buttons: once for ascending, again for descending, again for the suite's order.
export function sortable(table) {
  const columns = headings(table);
  for (const heading of columns) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'sort';
    button.append(...heading.childNodes);
    heading.append(button);
    heading.setAttribute('aria-sort', 'none');
    button.addEventListener('click', () => {
      const direction = NEXT[heading.getAttribute('aria-sort')];
      for (const other of columns) other.setAttribute('aria-sort', 'none');
      heading.setAttribute('aria-sort', direction);
      for (const body of table.tBodies) sortBody(body, heading.cellIndex, direction);
    });
  }
}
