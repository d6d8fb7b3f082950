// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The rows of a body that belong together: a row of the table, then its lines without a number of
// their own (intervals, figures of others).
export function rowGroups(body) {
  const groups = [];
  for (const row of body.rows) {
    const cell = row.querySelector('[data-row]');
    const id = cell ? cell.dataset.row : null;
    const last = groups.at(-1);
    if (last && (id === null || id === last.id)) last.rows.push(row);
    else groups.push({ id, rows: [row], order: groups.length });
  }
  return groups;
}

// The last line of the head: the one that names columns.
export function headings(table) {
  return [...(table.tHead?.rows[table.tHead.rows.length - 1]?.cells ?? [])];
}
