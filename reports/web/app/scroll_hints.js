// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { element } from './element.js';

// A table or chart that is wider than its place says that it goes on to the right.
function hintOf(place) {
  const hint = element('p', { class: 'scroll-hint', 'aria-hidden': 'true', hidden: '' }, 'scroll sideways \u2192');
  place.after(hint);
  return () => {
    const wide = place.scrollWidth > place.clientWidth + 1;
    hint.hidden = !wide;
    place.classList.toggle('more-right', wide && place.scrollLeft + place.clientWidth < place.scrollWidth - 1);
  };
}

export function scrollHints() {
  for (const place of document.querySelectorAll('.cvo-scroll, .plot-scroll')) {
    const update = hintOf(place);
    place.addEventListener('scroll', update, { passive: true });
    const sizes = new ResizeObserver(update);
    sizes.observe(place);
    for (const inner of place.children) sizes.observe(inner);
  }
}
