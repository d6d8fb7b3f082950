// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Colours of figures that follow the page's: taken from the style sheet, so that there is one place.
const dark = window.matchMedia('(prefers-color-scheme: dark)');

function variable(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function colours() {
  return {
    text: variable('--text'), muted: variable('--muted'), grid: variable('--grid'),
    panel: variable('--panel'), estimate: variable('--estimate'), truth: variable('--truth'),
  };
}

export function onThemeChange(act) {
  dark.addEventListener('change', () => act());
}

// For Plotly's layout.template: what a figure sets itself goes before.
export function template() {
  const { text, grid, muted } = colours();
  const axis = { gridcolor: grid, linecolor: muted, zerolinecolor: grid, tickcolor: muted, automargin: true, exponentformat: 'none' };
  const axis3d = { ...axis, backgroundcolor: 'rgba(0,0,0,0)', showbackground: false };
  return {
    data: { bar: [{ error_x: { color: muted }, error_y: { color: muted } }] },
    layout: {
      paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)',
      font: { color: text, family: 'system-ui, sans-serif', size: 12 },
      xaxis: axis, yaxis: axis,
      scene: { xaxis: axis3d, yaxis: axis3d, zaxis: axis3d },
      margin: { l: 50, r: 12, t: 24, b: 40 },
    },
  };
}
