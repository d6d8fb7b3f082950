// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the page says is in its HTML. This makes it sort, filter, open, draw and move.
import { openableCells } from './cell_dialog.js';
import { drawFiguresInView } from './figures.js';
import { readData } from './page_data.js';
import { sceneView } from './scene/scene_view.js';
import { scrollHints } from './scroll_hints.js';
import { arrowKeys } from './tables/arrow_keys.js';
import { foldNotes } from './tables/fold_notes.js';
import { tableTools } from './tables/table_tools.js';

const data = readData('page-data');
for (const frame of document.querySelectorAll('[data-table]')) {
  for (const table of frame.querySelectorAll('table')) {
    tableTools(table);
    openableCells(table, data[frame.dataset.table], data);
    arrowKeys(table);
  }
  foldNotes(frame);
}
scrollHints();
document.documentElement.dataset.ready = String(Math.round(performance.now()));

// Plotly and the large parts of the data stand below this script.
document.addEventListener('DOMContentLoaded', () => {
  drawFiguresInView();
  sceneView(document.getElementById('scene-view'), data);
});
