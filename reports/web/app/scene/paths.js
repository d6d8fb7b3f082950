// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { boxEdges, centerOf, pointAt, rowAt } from './run_at_frame.js';

// Lines as Plotly draws them: one list of points in which null ends a line. The page shows z
// forward and up upwards, so the axes are x, z and -y of the data.
export class Path {
  constructor() {
    this.x = [];
    this.y = [];
    this.z = [];
  }

  add(point) {
    this.x.push(point ? point[0] : null);
    this.y.push(point ? point[2] : null);
    this.z.push(point ? -point[1] : null);
  }
}

// The camera in the frames up to this one.
export function cameraPath(positions, last) {
  const path = new Path();
  for (let i = 0; i <= last; ++i) path.add(pointAt(positions, i));
  return path;
}

export function truthOfBodies(bodies) {
  const path = new Path();
  for (const body of bodies) {
    for (let i = 0; i < body.frames.length; ++i) path.add(pointAt(body.positions, i));
    path.add(null);
  }
  return path;
}

// Where true bodies are at a frame, with their names.
export function bodiesAt(bodies, frame) {
  const path = new Path();
  path.text = [];
  for (const body of bodies) {
    const row = rowAt(body.frames, frame);
    if (row < 0) continue;
    path.add(pointAt(body.positions, row));
    path.text.push(body.name);
  }
  return path;
}

// Where clusters have been in the last frames up to this one.
export function trails(clusters, frame, length) {
  const path = new Path();
  for (const cluster of clusters) {
    for (let row = 0; row < cluster.frames.length && cluster.frames[row] <= frame; ++row) {
      if (cluster.frames[row] >= frame - length) path.add(centerOf(cluster, row));
    }
    path.add(null);
  }
  return path;
}

// The boxes of those that are tracked, or of those that are predicted.
export function boxes(clusters, frame, predicted) {
  const path = new Path();
  for (const cluster of clusters) {
    const row = rowAt(cluster.frames, frame);
    if (row < 0 || Boolean(cluster.predicted[row]) !== predicted) continue;
    for (const [a, b] of boxEdges(cluster, row)) {
      path.add(a);
      path.add(b);
      path.add(null);
    }
  }
  return path;
}

// Centres of clusters with their ids.
export function labels(clusters, frame) {
  const path = new Path();
  path.text = [];
  path.colours = [];
  for (const cluster of clusters) {
    const row = rowAt(cluster.frames, frame);
    if (row < 0) continue;
    path.add(centerOf(cluster, row));
    path.text.push(cluster.predicted[row] ? `${cluster.id} (hidden)` : String(cluster.id));
    path.colours.push(cluster.colour);
  }
  return path;
}

// The boxes of all frames: what axes must hold.
export function allBoxes(clusters) {
  const path = new Path();
  for (const cluster of clusters) {
    for (let row = 0; row < cluster.frames.length; ++row) {
      for (const [a, b] of boxEdges(cluster, row)) {
        path.add(a);
        path.add(b);
      }
    }
  }
  return path;
}
