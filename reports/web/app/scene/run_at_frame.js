// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Pure functions from a run's data to what there is at a frame. Positions in the data are whole
// millimetres in the world of the first left camera: x right, y down, z forward.

const EDGES = [[0, 1], [1, 3], [3, 2], [2, 0], [4, 5], [5, 7], [7, 6], [6, 4], [0, 4], [1, 5], [2, 6], [3, 7]];

export function pointAt(list, index) {
  const [x, y, z] = list.slice(3 * index, 3 * index + 3);
  return x === null || x === undefined ? null : [x / 1000, y / 1000, z / 1000];
}

function rotate([qx, qy, qz, qw], [x, y, z]) {
  const tx = 2 * (qy * z - qz * y);
  const ty = 2 * (qz * x - qx * z);
  const tz = 2 * (qx * y - qy * x);
  return [x + qw * tx + qy * tz - qz * ty, y + qw * ty + qz * tx - qx * tz, z + qw * tz + qx * ty - qy * tx];
}

function inWorld(cluster, row, p) {
  const q = cluster.rotations.slice(4 * row, 4 * row + 4);
  const t = pointAt(cluster.positions, row);
  if (!t) return null;
  return rotate(q, p).map((value, i) => value + t[i]);
}

export function centerOf(cluster, row) {
  return inWorld(cluster, row, pointAt(cluster.centers, row) ?? [0, 0, 0]);
}

// The twelve edges of a cluster's box: pairs of points.
export function boxEdges(cluster, row) {
  const center = pointAt(cluster.centers, row) ?? [0, 0, 0];
  const half = pointAt(cluster.halves, row) ?? [0, 0, 0];
  const turn = cluster.turns.slice(4 * row, 4 * row + 4);
  const corners = [];
  for (let i = 0; i < 8; ++i) {
    const signs = [i & 1, i & 2, i & 4].map((bit) => (bit ? 1 : -1));
    const corner = rotate(turn, half.map((value, k) => signs[k] * value));
    corners.push(inWorld(cluster, row, center.map((value, k) => value + corner[k])));
  }
  return corners.includes(null) ? [] : EDGES.map(([a, b]) => [corners[a], corners[b]]);
}

// Index of the frame in an ascending list; -1: not there.
export function rowAt(frames, frame) {
  let low = 0;
  let high = frames.length - 1;
  while (low <= high) {
    const middle = (low + high) >> 1;
    if (frames[middle] === frame) return middle;
    if (frames[middle] < frame) low = middle + 1;
    else high = middle - 1;
  }
  return -1;
}

// Metres; null where truth or estimate is not there.
export function cameraError(run, frame) {
  const error = run.camera.errors_um[frame];
  return error === null || error === undefined ? null : error / 1e6;
}

// { metres, predicted } of a body at a frame; null where it has no estimate.
export function bodyError(body, frame) {
  for (const [list, predicted] of [[body.errors, false], [body.predicted, true]]) {
    const row = rowAt(list.frames, frame);
    if (row >= 0) return { metres: list.um[row] / 1e6, predicted };
  }
  return null;
}

// The image of a frame, or the last one before it; null where there is none.
export function imageAt(images, frame) {
  let found = null;
  for (const image of images) {
    if (image[0] > frame) break;
    found = image;
  }
  return found ?? images[0] ?? null;
}
