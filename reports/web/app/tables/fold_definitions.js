// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { element } from '../element.js';

// The definitions of columns are long and needed once.
export function foldDefinitions(frame) {
  const list = frame.querySelector('.cvo-definitions');
  if (!list) return;
  const heading = list.previousElementSibling;
  const name = heading?.matches('p') ? heading.textContent : 'What the columns are';
  if (heading?.matches('p')) heading.remove();
  const fold = element('details', {}, element('summary', {}, name));
  list.replaceWith(fold);
  fold.append(list);
}
