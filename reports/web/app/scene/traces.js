// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { allBoxes, bodiesAt, boxes, cameraPath, labels, trails, truthOfBodies } from './paths.js';

const TRAIL_FRAMES = 40;
const INK = '#e8eaed';
const TRUTH = '#9aa0a6';
const CAMERA = '#8ab4f8';
const GRID = '#3c4043';

// Hover texts and labels are markup to Plotly.
const plain = (text) => String(text).replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

function trace(flat, path, more) {
  const { x, y, z } = path;
  return { type: flat ? 'scatter' : 'scatter3d', x, y, ...(flat ? {} : { z }), hoverinfo: 'skip', ...more };
}

const line = (colour, width, dash = 'solid') => ({ mode: 'lines', line: { color: colour, width, dash } });

// What does not change with the frame.
export function fixedTraces(run, flat) {
  const last = run.frames.length - 1;
  const made = [trace(flat, cameraPath(run.camera.estimated, last), { ...line(CAMERA, 1), opacity: 0.5, name: 'camera, whole run', showlegend: false })];
  if (run.camera.truth) made.push(trace(flat, cameraPath(run.camera.truth, last), { ...line(TRUTH, 2), name: 'camera, truth' }));
  if (run.bodies.length > 0) made.push(trace(flat, truthOfBodies(run.bodies), { ...line(TRUTH, 1), opacity: 0.7, name: 'objects, truth' }));
  return made;
}

// What there is at a frame: always the same number of traces in the same order.
export function tracesAt(run, frame, flat) {
  const camera = cameraPath(run.camera.estimated, frame);
  const here = { x: camera.x.slice(-1), y: camera.y.slice(-1), z: camera.z.slice(-1) };
  const names = labels(run.clusters, frame);
  const truth = bodiesAt(run.bodies, frame);
  const made = [
    trace(flat, camera, { ...line(CAMERA, 4), name: 'camera' }),
    trace(flat, here, { mode: 'markers', marker: { color: CAMERA, size: flat ? 10 : 6, symbol: 'diamond' }, name: 'camera now', showlegend: false }),
    trace(flat, truth, { mode: 'markers', hoverinfo: 'text', hovertext: truth.text.map((name) => `truth: ${plain(name)}`), marker: { color: TRUTH, size: flat ? 7 : 4, symbol: 'cross' }, name: 'objects now, truth' }),
    trace(flat, names, { mode: 'markers+text', text: names.text.map(plain), textposition: 'top center', textfont: { color: INK, size: 13 }, marker: { color: names.colours, size: flat ? 8 : 4 }, name: 'clusters, by id' }),
  ];
  for (const colour of run.colours) {
    const clusters = run.clusters.filter((cluster) => cluster.colour === colour);
    made.push(
      trace(flat, trails(clusters, frame, TRAIL_FRAMES), { ...line(colour, 3), showlegend: false }),
      trace(flat, boxes(clusters, frame, false), { ...line(colour, flat ? 2 : 4), showlegend: false }),
      trace(flat, boxes(clusters, frame, true), { ...line(colour, flat ? 1.5 : 3, 'dash'), showlegend: false }),
    );
  }
  return made;
}

function range(lists) {
  let low = Infinity;
  let high = -Infinity;
  for (const list of lists) {
    for (const value of list) {
      if (value === null) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  if (low > high) return [-1, 1];
  const margin = 0.08 * (high - low) + 0.3;
  return [low - margin, high + margin];
}

// Axes hold the whole run, so that nothing jumps when time moves.
function ranges(run) {
  const last = run.frames.length - 1;
  const paths = [cameraPath(run.camera.estimated, last), truthOfBodies(run.bodies), trails(run.clusters, last, last), allBoxes(run.clusters)];
  return { x: range(paths.map((path) => path.x)), y: range(paths.map((path) => path.y)), z: range(paths.map((path) => path.z)) };
}

export function sceneLayout(run, flat, width) {
  const spans = ranges(run);
  const axis = (title, span) => ({ title: { text: title }, range: span, gridcolor: GRID, zerolinecolor: GRID, linecolor: TRUTH, color: INK, showbackground: false });
  const shared = {
    paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)', uirevision: 'keep',
    font: { color: INK, family: 'system-ui, sans-serif', size: 12 },
    legend: { orientation: 'h', x: 0, y: 1, yanchor: 'bottom', font: { size: 11 } },
  };
  if (flat) {
    return {
      ...shared, margin: { l: 48, r: 8, t: 8, b: 40 },
      xaxis: axis('right (m)', spans.x),
      yaxis: { ...axis('forward (m)', spans.y), scaleanchor: 'x' },
    };
  }
  const size = (span) => span[1] - span[0];
  const longest = Math.max(size(spans.x), size(spans.y), size(spans.z));
  const scale = width < 500 ? 1.0 : 1.25; // so that the axes' numbers and titles are in view
  const aspect = (span) => scale * Math.max(size(span) / longest, 0.15);
  return {
    ...shared, margin: { l: 0, r: 0, t: 0, b: 0 },
    scene: {
      xaxis: axis('right (m)', spans.x), yaxis: axis('forward (m)', spans.y), zaxis: axis('up (m)', spans.z),
      aspectmode: 'manual', aspectratio: { x: aspect(spans.x), y: aspect(spans.y), z: aspect(spans.z) },
      camera: { eye: { x: 0.15, y: -1.75, z: 1.05 }, center: { x: 0, y: 0, z: -0.3 }, up: { x: 0, y: 0, z: 1 } },
    },
  };
}

// Errors over time, in cm: of the camera and of every body that has any.
export function errorTraces(run, cameraErrors) {
  const cm = (metres) => (metres === null ? null : 100 * metres);
  const seconds = run.times_ms.map((ms) => ms / 1000);
  const made = [];
  if (run.camera.truth) made.push({ x: seconds, y: cameraErrors.map(cm), mode: 'lines', name: 'camera', line: { color: CAMERA, width: 2 } });
  for (const body of run.bodies) {
    const colour = run.clusters.find((cluster) => cluster.id === body.cluster)?.colour ?? TRUTH;
    for (const [list, symbol, name] of [[body.errors, 'circle', body.name], [body.predicted, 'circle-open', `${body.name}, hidden`]]) {
      if (list.frames.length === 0) continue;
      made.push({ x: list.frames.map((frame) => seconds[frame]), y: list.um.map((um) => um / 1e4), mode: 'markers', name: plain(name), marker: { color: colour, size: 4, symbol } });
    }
  }
  return made;
}

export function errorLayout() {
  const axis = { gridcolor: GRID, zerolinecolor: GRID, linecolor: TRUTH, color: INK, automargin: true, exponentformat: 'none' };
  return {
    paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)', font: { color: INK, family: 'system-ui, sans-serif', size: 12 },
    margin: { l: 52, r: 8, t: 8, b: 40 }, showlegend: true, legend: { orientation: 'h', y: 1, yanchor: 'bottom', x: 0, font: { size: 11 } },
    xaxis: { ...axis, title: { text: 'time (s)' } },
    yaxis: { ...axis, title: { text: 'position error (cm)' }, rangemode: 'tozero' },
  };
}

// A line at a time.
export function cursor(seconds) {
  return [{ type: 'line', x0: seconds, x1: seconds, yref: 'paper', y0: 0, y1: 1, line: { color: INK, width: 1 } }];
}
