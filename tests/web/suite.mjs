// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// A small suite, run by the program, and what a hostile or unlucky one looks like.
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

// Names as they would have to be to run script, were they ever taken for markup.
export const HOSTILE = '<img src=x onerror="window.hacked=1">';
export const BREAKOUT = '</script><script>window.hacked=2</script>';

const SUITE = {
  name: 'browser',
  about: 'Two forms of the estimator on a tiny scene',
  sequences: [
    { scene: 'tiny', detections: 'good' },
    { scene: 'tiny', detections: 'good', frames: '0:4', name: 'short' },
  ],
  variants: ['full', '2d', 'static'],
  seeds: 2,
  landmarks: true,
  table: {
    rows: ['sequence', 'variant'],
    metrics: ['camera_ate', 'moving_precision', 'moving_recall', 'object_unmatched_clusters'],
    reference: 'full',
  },
};

function run(program, out, ...args) {
  return execFileSync(program, args, {
    encoding: 'utf8',
    env: { ...process.env, CLUSTERVO_CACHE: join(out, 'cache') },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
}

// Exit code 1 says that something is missing, which the page says too.
function report(program, out, folder, ...more) {
  try {
    run(program, out, 'report', folder, ...more);
  } catch (error) {
    if (error.status !== 1) throw error;
  }
  return join(folder, 'report', 'index.html');
}

function edit(file, change) {
  const json = JSON.parse(readFileSync(file, 'utf8'));
  change(json);
  writeFileSync(file, JSON.stringify(json));
}

// A copy whose names are hostile, with a failed job, a half-written one and one of another schema.
function spoil(good, bad) {
  rmSync(bad, { recursive: true, force: true });
  cpSync(good, bad, { recursive: true });
  edit(join(bad, 'plan.json'), (plan) => {
    plan.suite.name = HOSTILE;
    plan.suite.about = BREAKOUT;
    for (const job of plan.jobs) {
      if (job.sequence === 'short') job.sequence = HOSTILE;
      if (job.variant === '2d') job.variant = BREAKOUT;
    }
  });
  const [failed, cut, old, ...rest] = readdirSync(join(bad, 'jobs')).sort();
  rmSync(join(bad, 'jobs', failed), { recursive: true });
  mkdirSync(join(bad, 'failed'), { recursive: true });
  const failure = { schema_version: 1, kind: 'failure', job: failed, message: HOSTILE, log: BREAKOUT };
  writeFileSync(join(bad, 'failed', `${failed}.json`), JSON.stringify(failure));
  const result = join(bad, 'jobs', cut, 'result.json');
  writeFileSync(result, readFileSync(result, 'utf8').slice(0, 2000));
  edit(join(bad, 'jobs', old, 'result.json'), (json) => { json.schema_version = 1; });
  for (const job of rest) {
    // A result counts only for the variant that the plan has.
    edit(join(bad, 'jobs', job, 'result.json'), (json) => { if (json.variant === '2d') json.variant = BREAKOUT; });
    edit(join(bad, 'jobs', job, 'timing.json'), (timing) => { timing.host = HOSTILE; });
    const truth = join(bad, 'jobs', job, 'truth.json');
    edit(truth, (json) => { for (const body of json.bodies) body.name = HOSTILE; });
  }
}

// Pages of the suite, compared with itself, and of its spoiled copy.
export function makePages(program, out) {
  mkdirSync(out, { recursive: true });
  const file = join(out, 'browser.json');
  writeFileSync(file, JSON.stringify(SUITE));
  const good = join(out, 'good');
  rmSync(good, { recursive: true, force: true });
  run(program, out, 'experiment', 'run', file, '-o', good, '-j', '2');
  const other = join(out, 'other');
  rmSync(other, { recursive: true, force: true });
  cpSync(good, other, { recursive: true });
  const bad = join(out, 'bad');
  spoil(good, bad);
  return { good: report(program, out, good, '--against', other, '--all-images'), bad: report(program, out, bad) };
}
