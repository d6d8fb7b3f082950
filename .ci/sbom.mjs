// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// Prints the bill of materials as SPDX 2.3 JSON: the Debian packages of packages.txt as they are
// installed here, and what npm fetches for the report page, with its checksums.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';

const read = (name) => readFileSync(new URL(`../${name}`, import.meta.url), 'utf8');
const run = (program, ...rest) => execFileSync(program, rest, { encoding: 'utf8' }).trim();

const version = /project\(ClusterVO VERSION ([\d.]+)/.exec(read('CMakeLists.txt'))[1];
const own = { name: 'ClusterVO-bench', versionInfo: version, licenseDeclared: 'Apache-2.0',
              downloadLocation: 'NOASSERTION' };

// Empty where it is not installed.
function installedVersion(name) {
  try {
    return run('dpkg-query', '-W', '-f', '${Version}', name);
  } catch {
    return '';
  }
}

function debianPackages() {
  const names = read('packages.txt').replace(/#.*/g, '').split(/\s+/).filter(Boolean);
  return names.map((name) => {
    const installed = installedVersion(name);
    const locator = `pkg:deb/debian/${encodeURIComponent(name)}${installed && `@${encodeURIComponent(installed)}`}`;
    return { name, versionInfo: installed || 'not installed here', licenseDeclared: 'NOASSERTION',
             downloadLocation: 'NOASSERTION', locator };
  });
}

function npmPackages() {
  const locked = Object.entries(JSON.parse(read('reports/web/package-lock.json')).packages);
  return locked.filter(([path]) => path !== '').map(([path, entry]) => {
    const name = path.slice(path.lastIndexOf('node_modules/') + 'node_modules/'.length);
    const [algorithm, digest] = entry.integrity.split('-');
    return { name, versionInfo: entry.version, licenseDeclared: entry.license ?? 'NOASSERTION',
             downloadLocation: entry.resolved,
             locator: `pkg:npm/${name.replace('@', '%40')}@${entry.version}`,
             checksums: [{ algorithm: algorithm.toUpperCase(),
                           checksumValue: Buffer.from(digest, 'base64').toString('hex') }] };
  });
}

function described({ locator, ...entry }, index) {
  const references = locator && [{ referenceCategory: 'PACKAGE-MANAGER', referenceType: 'purl',
                                   referenceLocator: locator }];
  return { SPDXID: `SPDXRef-${index}`, filesAnalyzed: false, licenseConcluded: 'NOASSERTION',
           copyrightText: 'NOASSERTION', ...entry, ...(references && { externalRefs: references }) };
}

const packages = [own, ...debianPackages(), ...npmPackages()].map(described);
const hash = createHash('sha256').update(JSON.stringify(packages)).digest('hex');
const document = {
  spdxVersion: 'SPDX-2.3',
  dataLicense: 'CC0-1.0',
  SPDXID: 'SPDXRef-DOCUMENT',
  name: `${own.name}-${version}`,
  documentNamespace: `urn:sha256:${hash}`,
  creationInfo: { created: new Date(1000 * Number(run('git', 'log', '-1', '--format=%ct')))
                    .toISOString().replace('.000', ''),
                  creators: ['Tool: .ci/sbom.mjs'] },
  packages,
  relationships: packages.slice(1).map(({ SPDXID }) => ({
    spdxElementId: packages[0].SPDXID, relationshipType: 'DEPENDS_ON', relatedSpdxElement: SPDXID })),
};
document.relationships.unshift({ spdxElementId: document.SPDXID, relationshipType: 'DESCRIBES',
                                 relatedSpdxElement: packages[0].SPDXID });
console.log(JSON.stringify(document, null, 2));
