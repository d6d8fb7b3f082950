// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// mutate.mjs MUTANTS SEED [FOLDER]: changes one token at a time in a copy of the sources
// (build/mutation, kept for the next call), builds the test programs of the folder and says which changes
// they do not find. Every survivor is a missing test, or a change that changes nothing.
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const testsOf = {
  'core/estimation': ['estimation_test', 'odometry_parts_test', 'odometry_backends_test'],
  'experiments/metrics': ['metrics_test', 'kitti_ap_test', 'tracking_scores_test'],
  'reports/statistics': ['statistics_test'],
};
const swaps = [
  ['<', '<='], ['<=', '<'], ['>', '>='], ['>=', '>'], ['==', '!='], ['!=', '=='], ['&&', '||'], ['||', '&&'],
  ['+', '-'], ['-', '+'], ['*', '/'], ['/', '*'], ['+=', '-='], ['-=', '+='],
];
const tree = join('build', 'mutation');
const built = join(tree, 'build', 'release');
const kPatience = 10; // times as long as the tests of the unchanged sources take

const files = (folder) => execFileSync('git', ['ls-files', folder], { encoding: 'utf8' }).split('\n').filter(Boolean);

// What an earlier call copied.
function filesOfTree() {
  mkdirSync(tree, { recursive: true });
  const all = ['.', '-path', './build', '-prune', '-o', '-type', 'f', '-printf', '%P\n'];
  return execFileSync('find', all, { encoding: 'utf8', cwd: tree }).split('\n').filter(Boolean);
}

// Without what stands in quotes or after //, at the same columns.
const codeOf = (line) => line.replace(/"(?:[^"\\]|\\.)*"|\/\/.*/g, (text) => '_'.repeat(text.length));

// All changes of a line: what it becomes.
function mutantsOf(line) {
  const code = codeOf(line);
  if (/^\s*(#|using |template|static_assert)/.test(code)) return [];
  const found = [];
  const replace = (at, length, by) => found.push(line.slice(0, at) + by + line.slice(at + length));
  for (const [from, to] of swaps) {
    for (let at = code.indexOf(` ${from} `); at >= 0; at = code.indexOf(` ${from} `, at + 1)) {
      replace(at + 1, from.length, to);
    }
  }
  for (const number of code.matchAll(/(?<![\w.])\d+(?:\.\d+)?(?![\w.'])/g)) {
    const value = number[0];
    replace(number.index, value.length, value.includes('.') ? (Number(value) + 1).toFixed(1) : `${Number(value) + 1}`);
  }
  for (const word of code.matchAll(/\b(true|false)\b/g)) {
    replace(word.index, word[0].length, word[0] === 'true' ? 'false' : 'true');
  }
  const isStatement = /^\s*(?:[\w.[\]()*>-]+ [-+*/]?= .*|\+\+[\w.>-]+|[\w.>-]+\(.*\)|continue|break);$/.test(code);
  if (isStatement && !/^\s*(return|throw|[A-Z]\w* )/.test(code)) found.push(line.replace(/\S.*/, ';'));
  return found;
}

function allMutants(folders) {
  const mutants = [];
  for (const folder of folders) {
    for (const file of files(folder).filter((name) => name.endsWith('.cc'))) {
      readFileSync(file, 'utf8').split('\n').forEach((line, index) => {
        for (const after of mutantsOf(line)) mutants.push({ folder, file, index, before: line, after });
      });
    }
  }
  return mutants;
}

// The same ones for the same seed.
function drawn(mutants, count, seed) {
  let state = BigInt(seed);
  const next = (below) => {
    state = (state * 6364136223846793005n + 1442695040888963407n) & ((1n << 64n) - 1n);
    return Number((state >> 33n) % BigInt(below));
  };
  const left = [...mutants];
  const chosen = [];
  while (chosen.length < count && left.length > 0) chosen.push(...left.splice(next(left.length), 1));
  return chosen;
}

function build(targets) {
  return spawnSync('ninja', ['-C', built, ...targets], { encoding: 'utf8' });
}

// Where CMake puts them.
function programs(targets) {
  const found = execFileSync('find', [join(built, 'tests'), '-type', 'f', '-name', '*_test'], { encoding: 'utf8' });
  return targets.map((target) => found.split('\n').find((path) => path.endsWith(`/${target}`)));
}

const passes = (program, timeout) =>
  spawnSync(program, ['--gtest_brief=1'], { stdio: 'ignore', timeout }).status === 0;

// "killed", "survived" or "not built". Programs are built one by one: most changes do not outlive the first.
function judge(mutant, longest_ms) {
  const path = join(tree, mutant.file);
  const good = readFileSync(path, 'utf8');
  const lines = good.split('\n');
  lines[mutant.index] = mutant.after;
  writeFileSync(path, lines.join('\n'));
  try {
    for (const target of testsOf[mutant.folder]) {
      if (build([target]).status !== 0) return 'not built';
      if (!passes(programs([target])[0], longest_ms)) return 'killed';
    }
    return 'survived';
  } finally {
    writeFileSync(path, good);
  }
}

function main(count, seed, only) {
  const folders = Object.keys(testsOf).filter((folder) => !only || folder === only);
  if (!(count > 0) || !/^\d+$/.test(seed) || folders.length === 0) {
    console.error(`mutate.mjs MUTANTS SEED [${Object.keys(testsOf).join(' | ')}]`);
    return 2;
  }
  const sources = new Set(files('.'));
  for (const file of filesOfTree()) {
    if (!sources.has(file)) rmSync(join(tree, file));
  }
  for (const file of sources) {
    const copy = join(tree, file);
    mkdirSync(dirname(copy), { recursive: true });
    if (!existsSync(copy) || !readFileSync(copy).equals(readFileSync(file))) cpSync(file, copy);
  }
  execFileSync('cmake', ['--preset', 'release', '-DCMAKE_CXX_COMPILER_LAUNCHER=ccache'], { cwd: tree, stdio: 'ignore' });
  const targets = folders.flatMap((folder) => testsOf[folder]);
  const first = build(targets);
  const start = Date.now();
  if (first.status !== 0 || !programs(targets).every((program) => passes(program))) {
    console.error(`mutate.mjs: the tests do not pass as they are\n${first.stdout.slice(-2000)}`);
    return 1;
  }
  const longest_ms = kPatience * (Date.now() - start);
  const counts = { killed: 0, survived: 0, 'not built': 0 };
  for (const mutant of drawn(allMutants(folders), count, seed)) {
    const outcome = judge(mutant, longest_ms);
    ++counts[outcome];
    console.log(`${outcome}: ${mutant.file}:${mutant.index + 1}: ${mutant.before.trim()}  =>  ${mutant.after.trim()}`);
  }
  const judged = counts.killed + counts.survived;
  console.log(`${counts.killed} of ${judged} killed (${((100 * counts.killed) / Math.max(judged, 1)).toFixed(0)} %), ` +
              `${counts['not built']} not built`);
  return 0;
}

process.exitCode = main(Number(process.argv[2]), process.argv[3] ?? '', process.argv[4]);
