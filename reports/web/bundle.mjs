// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// node bundle.mjs APP_FOLDER NODE_MODULES OUT: makes of the app one script and one style sheet, and
// the policy that lets a page run these scripts and nothing else.
import { createHash } from 'node:crypto';
import { copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [app, modules, out] = process.argv.slice(2).map((path) => resolve(path));
const esbuild = createRequire(join(modules, 'x.js'))('esbuild');

const options = { bundle: true, minify: true, charset: 'utf8', logLevel: 'warning', target: 'es2022' };
esbuild.buildSync({ ...options, entryPoints: [join(app, 'main.js')], format: 'iife', outfile: join(out, 'app.js') });
esbuild.buildSync({ ...options, entryPoints: [join(app, 'style.css')], outfile: join(out, 'app.css') });

const plotly = join(modules, 'plotly.js-dist-min');
copyFileSync(join(plotly, 'plotly.min.js'), join(out, 'plotly.js'));
copyFileSync(join(plotly, 'LICENSE'), join(out, 'plotly_licence.txt'));

// A browser compares the hash of what stands between <script> and </script>.
const scripts = ['app.js', 'plotly.js'].map((name) => {
  const text = readFileSync(join(out, name), 'utf8');
  if (/<\/?script|\r/i.test(text)) throw new Error(`${name}: cannot stand within a page`);
  return `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
});
const policy = [
  "default-src 'none'",
  `script-src ${scripts.join(' ')}`,
  "style-src 'unsafe-inline'", // Plotly styles its elements
  'img-src data: blob:',
  "base-uri 'none'",
  "form-action 'none'",
];
writeFileSync(join(out, 'policy.txt'), policy.join('; '));
