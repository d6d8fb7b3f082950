// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// The rows of a body that belong together: a row of the table and the figures of others below it.
export function rowGroups(body) {
  const groups = [];
  for (const row of body.rows) {
    const id = row.dataset.row;
    const last = groups.at(-1);
    if (last && id !== undefined && id === last.id) last.rows.push(row);
    else groups.push({ id, rows: [row], order: groups.length });
  }
  return groups;
}

// The last line of the head: the one that names columns.
export function headings(table) {
  return [...(table.tHead?.rows[table.tHead.rows.length - 1]?.cells ?? [])];
}
