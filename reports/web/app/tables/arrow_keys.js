// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
const STEPS = {
  ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0],
};

function buttonsByRow(table) {
  return [...table.tBodies].flatMap((body) => [...body.rows])
    .filter((row) => !row.hidden)
    .map((row) => [...row.querySelectorAll('button.cell')].filter((cell) => !cell.closest('td').hidden))
    .filter((row) => row.length > 0);
}

// Tab enters the cells of a table once; arrows, Home and End move within them.
export function arrowKeys(table) {
  const all = [...table.querySelectorAll('button.cell')];
  all.forEach((button, index) => { button.tabIndex = index === 0 ? 0 : -1; });
  table.addEventListener('focusin', (event) => {
    if (!event.target.matches('button.cell')) return;
    for (const button of all) button.tabIndex = button === event.target ? 0 : -1;
  });
  table.addEventListener('keydown', (event) => {
    if (!event.target.matches('button.cell')) return;
    const rows = buttonsByRow(table);
    const row = rows.findIndex((buttons) => buttons.includes(event.target));
    const column = rows[row].indexOf(event.target);
    let next = null;
    if (event.key in STEPS) {
      const [down, right] = STEPS[event.key];
      next = rows[row + down]?.[column + right];
    } else if (event.key === 'Home') {
      next = rows[row][0];
    } else if (event.key === 'End') {
      next = rows[row].at(-1);
    } else {
      return;
    }
    event.preventDefault();
    next?.focus();
  });
}
