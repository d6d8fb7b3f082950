// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// fuzz.mjs RUNS HOURS SEED JOBS [PARSER]: gives every parser RUNS files that libFuzzer makes, all of them
// within HOURS (0: however long it takes), JOBS parsers at once (0: one per processor). Corpora are kept
// in build/fuzz/attack and grow from call to call. What is found is named, and read again by every call.
import { spawn, spawnSync } from 'node:child_process';
import { createWriteStream, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join, relative, resolve } from 'node:path';

const program = resolve('build/fuzz/tests/faults/fuzz_target');
const attack = resolve('build/fuzz/attack');
const kLongest_s = 20; // for one file, on a loaded machine
const kMost_mb = 2048;
// Reading a seed frees 0.01 to 0.3 MB. The sanitizer's own 256 MB of freed memory that waits cost half of the time.
const kQuarantine_mb = 4;
const memory = mkdtempSync(existsSync('/dev/shm') ? '/dev/shm/fuzz_' : join(tmpdir(), 'fuzz_'));
const columns = [14, 11, 9, 8, 10, 9];

const row = (cells) => cells.map((cell, i) => (i ? `${cell}`.padStart(columns[i]) : cell.padEnd(columns[i]))).join('');
const last = (log, pattern) => [...log.matchAll(pattern)].at(-1)?.[1] ?? '0';

// One line of the table; whether the attack ended without a finding.
async function attackOne(name, { runs, share_s, seed }) {
  const folder = join(attack, name);
  for (const part of ['corpus', 'findings']) mkdirSync(join(folder, part), { recursive: true });
  const log = createWriteStream(join(folder, 'log'));
  const flags = [`-runs=${runs}`, `-max_total_time=${share_s}`, `-seed=${seed}`, `-timeout=${kLongest_s}`,
    `-rss_limit_mb=${kMost_mb}`, '-dict=dictionary', '-artifact_prefix=findings/', '-print_final_stats=1'];
  const env = { ...process.env, TMPDIR: memory, UBSAN_OPTIONS: 'print_stacktrace=1',
    ASAN_OPTIONS: `quarantine_size_mb=${kQuarantine_mb}` };
  const start = Date.now();
  const code = await new Promise((done) => {
    const child = spawn(program, [name, ...flags, 'corpus', 'seeds', 'findings'], { cwd: folder, env });
    child.stdout.pipe(log, { end: false });
    child.stderr.pipe(log, { end: false });
    child.on('close', (status) => log.end(() => done(status)));
  });
  const seconds = (Date.now() - start) / 1000;
  const said = readFileSync(join(folder, 'log'), 'utf8');
  const executions = last(said, /number_of_executed_units: (\d+)/g);
  const found = last(said, /Test unit written to (\S+)/g);
  console.log(row([name, executions, seconds.toFixed(0), Math.round(executions / seconds), last(said, /cov: (\d+)/g),
    code === 0 ? 0 : 1]));
  const input = found === '0' ? '' : `${relative('.', program)} ${name} ${relative('.', join(folder, found))}, `;
  if (code !== 0) console.log(`  finding: ${input}${relative('.', join(folder, 'log'))}`);
  return code === 0;
}

async function main([runs, hours, seed, jobs, only]) {
  const seeds = spawnSync(program, ['seeds', attack], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit'] });
  const names = seeds.stdout.split('\n').filter((name) => name && (!only || name === only));
  const workers = Math.min(Number(jobs) || availableParallelism(), names.length);
  const share_s = Math.ceil((Number(hours) * 3600 * workers) / names.length);
  console.log(row(['parser', 'executions', 'seconds', 'per s', 'coverage', 'findings']));
  let good = seeds.status === 0 && names.length > 0;
  await Promise.all(Array.from({ length: workers }, async () => {
    while (names.length) good = (await attackOne(names.shift(), { runs, share_s, seed })) && good;
  }));
  return good ? 0 : 1;
}

try {
  process.exitCode = await main(process.argv.slice(2));
} finally {
  rmSync(memory, { recursive: true });
}
