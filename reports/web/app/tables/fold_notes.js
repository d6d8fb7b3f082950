// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { element } from '../element.js';

function fold(list, name) {
  const folded = element('details', {}, element('summary', {}, name));
  list.replaceWith(folded);
  folded.append(list);
}

// Notes and definitions are long; what most readers need of them is said above the table.
export function foldNotes(frame) {
  const notes = frame.querySelector('.cvo-footnotes');
  if (notes) fold(notes, 'Notes: what each value is based on, and how values are compared');
  const list = frame.querySelector('.cvo-definitions');
  if (!list) return;
  if (list.previousElementSibling?.matches('p')) list.previousElementSibling.remove();
  fold(list, 'Definitions of the columns');
}
