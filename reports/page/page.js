// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
// What the page says is in its HTML. This sorts tables, moves through the frames of runs, and goes
// to what the address names: #table-values/2/descending sorts, #frames-1/30 shows frame 30.
'use strict';

window.addEventListener('error', (event) => {
  const problem = document.getElementById('script-problem');
  problem.textContent = `The script of this page failed: ${event.message}`;
  problem.hidden = false;
});

function element(tag, text = '') {
  const made = document.createElement(tag);
  made.textContent = text;
  return made;
}

function svgElement(tag, attributes) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}

const words = (text) => (text ? text.split(' ') : []);
const numbers = (text) => words(text).map(Number);

// Index of the last number that is at most `most` in an ascending list; -1: none.
function lastAtMost(list, most) {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle] <= most) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

// So that the address can be copied.
function setAddress(...parts) {
  history.replaceState(null, '', `#${parts.join('/')}`);
}

// ---- Tables

const NEXT = { none: 'ascending', ascending: 'descending', descending: 'none' };

function sortKey(row, column) {
  const cell = row.cells[column];
  if (cell?.dataset.value) return { number: Number(cell.dataset.value) };
  const text = cell?.textContent.trim() ?? '';
  return { text, empty: text === '' || text.startsWith('-') };
}

// What has no value comes last, whatever the direction.
function compareKeys(a, b, sign) {
  if (a.empty || b.empty) return Number(a.empty ?? false) - Number(b.empty ?? false);
  if (a.number !== undefined && b.number !== undefined) return sign * (a.number - b.number);
  if (a.number !== undefined || b.number !== undefined) return a.number !== undefined ? -1 : 1;
  return sign * a.text.localeCompare(b.text, 'en', { numeric: true });
}

// A row with the figures of others below it.
function rowGroups(body) {
  const groups = [];
  for (const row of body.rows) {
    if (row.classList.contains('below') && groups.length > 0) groups.at(-1).push(row);
    else groups.push([row]);
  }
  return groups;
}

// Headings become buttons: once for ascending, again for descending, again for the first order.
function makeSortable(table) {
  const headings = [...table.tHead.rows[0].cells];
  const body = table.tBodies[0];
  const first = rowGroups(body);
  const sortBy = (column, direction) => {
    headings.forEach((heading, i) => heading.setAttribute('aria-sort', i === column ? direction : 'none'));
    const groups = [...first];
    if (direction !== 'none') {
      const sign = direction === 'ascending' ? 1 : -1;
      groups.sort((a, b) => compareKeys(sortKey(a[0], column), sortKey(b[0], column), sign));
    }
    body.append(...groups.flat());
  };
  headings.forEach((heading, column) => {
    const button = element('button');
    button.type = 'button';
    button.append(...heading.childNodes);
    heading.append(button);
    heading.setAttribute('aria-sort', 'none');
    button.addEventListener('click', () => {
      const direction = NEXT[heading.getAttribute('aria-sort')];
      sortBy(column, direction);
      setAddress(table.id, column, direction);
    });
  });
  table.goTo = (column, direction) => {
    if (headings[column] && direction in NEXT) sortBy(Number(column), direction);
  };
}

// ---- Runs frame by frame

function lengthText(mm) {
  if (mm < 10) return `${mm.toFixed(2)} mm`;
  return mm < 1000 ? `${(mm / 10).toFixed(1)} cm` : `${(mm / 1000).toFixed(2)} m`;
}

// A path of the map: `show` draws it up to a frame and returns what there is to say about it.
function pathOf(line) {
  const { name, mark = '', marked } = line.dataset;
  const frames = numbers(line.dataset.frames);
  const errors = words(line.dataset.errorsMm);
  const points = words(line.getAttribute('points'));
  const hidden = new Set(numbers(marked));
  const isTruth = line.classList.contains('truth');
  const size = Number(line.ownerSVGElement.getAttribute('font-size'));
  const colour = line.getAttribute('stroke');
  const here = svgElement('circle', { r: size / 3, class: `here ${line.classList}` });
  if (colour) here.setAttribute('stroke', colour);
  const label = svgElement('text', { class: 'here' });
  label.textContent = /^cluster (\d+)/.exec(name)?.[1] ?? '';
  line.ownerSVGElement.append(here, label);
  return (frame) => {
    const last = lastAtMost(frames, frame);
    const isHere = last >= 0 && frames[last] === frame;
    for (const part of [here, label]) part.toggleAttribute('hidden', !isHere);
    if (!isTruth) line.setAttribute('points', points.slice(0, last + 1).join(' '));
    if (!isHere) return null;
    const [x, y] = numbers(points[last].replace(',', ' '));
    here.setAttribute('cx', x);
    here.setAttribute('cy', y);
    here.classList.toggle('marked', hidden.has(frame));
    label.setAttribute('x', x + size / 2);
    label.setAttribute('y', y - size / 2);
    if (isTruth) return null;
    const error = errors[last] === '-' ? '' : `, ${lengthText(Number(errors[last]))} off`;
    return `${name}${hidden.has(frame) ? `: ${mark}` : ''}${error}`;
  };
}

function runOf(place) {
  const paths = [...place.querySelectorAll('.map polyline[data-name]')].map(pathOf);
  const images = [...place.querySelectorAll('.images img')];
  const imageFrames = images.map((image) => Number(image.dataset.frame));
  const caption = place.querySelector('.images figcaption');
  const list = place.querySelector('.words');
  return (frame) => {
    if (images.length > 0) {
      const shown = Math.max(0, lastAtMost(imageFrames, frame));
      images.forEach((image, i) => { image.hidden = i !== shown; });
      caption.textContent = `Frame ${imageFrames[shown]}: ${images[shown].alt}`;
    }
    const said = paths.map((show) => show(frame)).filter((text) => text !== null);
    list.replaceChildren(...(said.length > 0 ? said : ['this run does not have the frame']).map((text) => element('li', text)));
  };
}

// One slider for all runs on a sequence, drawn when it is first unfolded.
function makePlayer(block) {
  const frames = numbers(block.dataset.frames);
  if (frames.length === 0) return;
  const times = numbers(block.dataset.timesMs);
  const player = block.querySelector('.player');
  const [play, slider, output] = player.children;
  const stepMs = window.matchMedia('(prefers-reduced-motion: reduce)').matches ? 1000 : 120;
  let runs = null;
  let timer = null;

  const show = (index) => {
    runs ??= [...block.querySelectorAll('.run')].map(runOf);
    slider.value = String(index);
    for (const run of runs) run(frames[index]);
    output.textContent = `frame ${frames[index]} (${index + 1} of ${frames.length}), ${(times[index] / 1000).toFixed(2)} s`;
    slider.setAttribute('aria-valuetext', output.textContent);
    block.dataset.frame = String(frames[index]);
  };
  const stop = () => {
    clearInterval(timer);
    timer = null;
    play.textContent = 'Play';
  };
  const step = () => {
    if (slider.value === slider.max) stop();
    else show(Number(slider.value) + 1);
  };

  slider.max = String(frames.length - 1);
  player.hidden = false;
  slider.addEventListener('input', () => show(Number(slider.value)));
  slider.addEventListener('change', () => setAddress(block.id, frames[Number(slider.value)]));
  play.addEventListener('click', () => {
    if (timer !== null) {
      stop();
      return;
    }
    if (slider.value === slider.max) show(0);
    play.textContent = 'Pause';
    timer = setInterval(step, stepMs);
  });
  const unfolded = () => {
    if (block.open && runs === null) show(frames.length >> 1);
    if (!block.open) stop();
  };
  block.addEventListener('toggle', unfolded);
  unfolded();
  block.goTo = (frame) => show(Math.max(0, lastAtMost(frames, Number(frame))));
}

// ---- The address

function followAddress() {
  const [id, ...rest] = decodeURIComponent(location.hash.slice(1)).split('/');
  const target = document.getElementById(id);
  if (!target) return;
  for (let at = target; at; at = at.parentElement) {
    if (at.tagName === 'DETAILS') at.open = true;
  }
  if (rest.length === 0) return;
  target.goTo?.(...rest);
  target.scrollIntoView();
}

document.querySelectorAll('table.results').forEach(makeSortable);
document.querySelectorAll('details.frames').forEach(makePlayer);
followAddress();
window.addEventListener('hashchange', followAddress);
document.documentElement.dataset.ready = 'true';
