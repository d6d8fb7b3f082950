// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { readData } from './page_data.js';
import { onThemeChange, template } from './theme.js';

// No button may send a figure anywhere: the page needs no network.
export const CONFIG = {
  responsive: true, displaylogo: false, showTips: false, scrollZoom: false, showSendToCloud: false,
};

const drawn = new Set();

// Both axes in metres on one scale: what is narrower is also lower, else it would have gaps.
const oneScale = (layout) => layout.yaxis?.scaleanchor !== undefined;

function heightFor(plot, layout) {
  const { l, r, t, b } = layout.margin;
  const meant = Number(plot.dataset.width);
  plot.style.maxWidth = `${meant}px`;
  const part = Math.min(1, Math.max(0.2, (plot.clientWidth - l - r) / (meant - l - r)));
  const height = Math.round(t + b + part * (layout.height - t - b));
  plot.style.minHeight = `${height}px`;
  return height;
}

function followWidth(plot, layout) {
  let width = plot.clientWidth;
  new ResizeObserver(() => {
    if (plot.clientWidth === width) return;
    width = plot.clientWidth;
    window.Plotly.relayout(plot, { height: heightFor(plot, layout) });
  }).observe(plot.parentElement);
}

function draw(figure) {
  const plot = figure.querySelector('.plot');
  const { data, layout } = readData(figure.dataset.figure) ?? {};
  if (!data) {
    plot.textContent = 'This figure could not be made.';
    return;
  }
  const size = oneScale(layout) ? { height: heightFor(plot, layout) } : {};
  // The caption is text of the page.
  window.Plotly.newPlot(plot, data, { ...layout, ...size, title: undefined, template: template() }, CONFIG);
  if (oneScale(layout)) followWidth(plot, layout);
  figure.dataset.drawn = 'true';
  drawn.add(plot);
}

// Each figure is drawn when it is about to be seen.
export function drawFiguresInView() {
  const observer = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      observer.unobserve(target);
      draw(target);
    }
  }, { rootMargin: '300px' });
  for (const figure of document.querySelectorAll('[data-figure]')) observer.observe(figure);
  onThemeChange(() => {
    for (const plot of drawn) window.Plotly.relayout(plot, { template: template() });
  });
  window.addEventListener('beforeprint', () => {
    for (const figure of document.querySelectorAll('[data-figure]:not([data-drawn])')) draw(figure);
  });
}
