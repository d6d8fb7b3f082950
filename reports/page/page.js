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

function makePlayer(block) {
  const images = [...block.querySelectorAll('img')];
  const caption = block.querySelector('figcaption');
  const player = block.querySelector('.player');
  const [play, slider] = player.children;
  const stepMs = window.matchMedia('(prefers-reduced-motion: reduce)').matches ? 1000 : 120;
  let timer = null;

  const show = (index) => {
    slider.value = String(index);
    images.forEach((image, i) => { image.hidden = i !== index; });
    caption.textContent = images[index].alt;
    slider.setAttribute('aria-valuetext', caption.textContent);
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

  slider.max = String(images.length - 1);
  player.hidden = false;
  slider.addEventListener('input', () => show(Number(slider.value)));
  slider.addEventListener('change', () => setAddress(block.id, images[Number(slider.value)].dataset.frame));
  play.addEventListener('click', () => {
    if (timer !== null) {
      stop();
      return;
    }
    if (slider.value === slider.max) show(0);
    play.textContent = 'Pause';
    timer = setInterval(step, stepMs);
  });
  show(images.length >> 1);
  // The last image that is not after this frame.
  block.goTo = (frame) => show(Math.max(0, images.filter((image) => Number(image.dataset.frame) <= Number(frame)).length - 1));
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
document.querySelectorAll('.frames').forEach(makePlayer);
followAddress();
window.addEventListener('hashchange', followAddress);
document.documentElement.dataset.ready = 'true';
