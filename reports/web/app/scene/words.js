// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { bodyError, cameraError, rowAt } from './run_at_frame.js';

function length(metres) {
  if (metres < 0.01) return `${(1000 * metres).toFixed(2)} mm`;
  return metres < 1 ? `${(100 * metres).toFixed(1)} cm` : `${metres.toFixed(2)} m`;
}

function bodyOf(run, cluster) {
  return run.bodies.find((body) => body.cluster === cluster.id);
}

function clusterWords(run, cluster, frame) {
  const row = rowAt(cluster.frames, frame);
  if (row < 0) return null;
  const body = bodyOf(run, cluster);
  const error = body ? bodyError(body, frame) : null;
  const state = cluster.predicted[row] ? 'hidden, predicted' : 'tracked';
  const off = error ? `, ${length(error.metres)} off` : body ? '' : ', no true object';
  return `cluster ${cluster.id}${cluster.category ? ` (${cluster.category})` : ''}: ${state}${off}`;
}

// What there is at a frame, one text per thing.
export function wordsAt(run, frame) {
  const error = cameraError(run, frame);
  const camera = `camera: ${run.camera.states[frame]}${error === null ? ', truth not known' : `, ${length(error)} off`}`;
  return [camera, ...run.clusters.map((cluster) => clusterWords(run, cluster, frame)).filter(Boolean)];
}
