// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { element } from '../element.js';
import { CONFIG } from '../figures.js';
import { readData } from '../page_data.js';
import { player } from './player.js';
import { cameraError, imageAt } from './run_at_frame.js';
import { cursor, errorLayout, errorTraces, fixedTraces, sceneLayout, tracesAt } from './traces.js';
import { hasWebgl } from './webgl.js';
import { wordsAt } from './words.js';

function runName(scene, data) {
  const { keys, seed } = data.runs[scene.run];
  const { sequence, variant, ...rest } = keys;
  const more = Object.entries(rest).filter(([key]) => key !== 'detections').map(([key, value]) => `${key} ${value}`);
  return [sequence, variant, ...more, `seed ${seed}`].join(', ') + (scene.images > 0 ? ' (with images)' : '');
}

function parts(data) {
  const options = data.scenes.map((scene, i) => element('option', { value: i }, runName(scene, data)));
  return {
    choice: element('select', {}, options),
    flat: element('input', { type: 'checkbox' }),
    note: element('p', { class: 'note', role: 'status' }),
    plot: element('div', { class: 'plot scene-plot', role: 'img' }),
    image: element('img', { alt: '', class: 'frame-image' }),
    imageNote: element('figcaption'),
    all: element('p', { class: 'all-frames' }),
    errors: element('div', { class: 'plot error-plot', role: 'img' }),
    words: element('ul', { class: 'words' }),
    beside: element('select', {}),
    grid: element('div', { class: 'scene-grid' }),
    other: besideParts(),
  };
}

// Of the run that is shown beside the chosen one.
function besideParts() {
  return {
    side: element('div', { class: 'scene-side', hidden: '' }),
    name: element('h3'),
    image: element('img', { alt: 'no run beside', class: 'frame-image' }),
    imageNote: element('figcaption'),
    words: element('ul', { class: 'words' }),
  };
}

// The other runs on the sequence of the chosen one; the page of single runs begins with the next.
function offerBeside(view, data, chosen) {
  const sequence = (i) => data.runs[data.scenes[i].run].keys.sequence;
  const others = data.scenes.map((_, i) => i).filter((i) => i !== chosen && sequence(i) === sequence(chosen));
  view.beside.replaceChildren(element('option', { value: '' }, 'none'),
    ...others.map((i) => element('option', { value: i }, runName(data.scenes[i], data))));
  const both = others.find((i) => data.scenes[i].images > 0 && data.scenes[chosen].images > 0);
  view.beside.value = both === undefined ? '' : String(both);
}

function arrange(place, view, playerRow) {
  place.replaceChildren(
    element('div', { class: 'tools' }, element('label', {}, 'Run ', view.choice),
      element('label', {}, 'Beside it ', view.beside),
      element('label', {}, view.flat, ' from above (2D)')),
    view.note, playerRow, view.grid);
  view.other.side.replaceChildren(view.other.name,
    element('figure', { class: 'frame' }, view.other.image, view.other.imageNote),
    element('div', { class: 'now' }, view.other.words));
  view.grid.replaceChildren(
      view.plot,
      element('div', { class: 'scene-side' },
        element('figure', { class: 'frame' }, view.image, view.imageNote, view.all),
        element('div', { class: 'now' }, element('h3', {}, 'At this frame'), view.words)),
      view.other.side,
      view.errors);
}

function prepared(index) {
  const run = readData(`scene-${index}`);
  run.colours = [...new Set(run.clusters.map((cluster) => cluster.colour))];
  return run;
}

function showImage(view, run, scene, frame) {
  const image = imageAt(run.images, frame);
  view.image.hidden = !image;
  if (!image) {
    view.imageNote.textContent = scene.no_images || 'Images are in the page for one estimator per sequence only.';
    return;
  }
  if (view.image.src !== image[1]) view.image.src = image[1];
  view.image.dataset.frame = String(run.frames[image[0]]);
  view.image.alt = image[2];
  view.imageNote.textContent = `Left image of frame ${run.frames[image[0]]} with what was estimated`;
}

// A run in 3D, its images and its errors, all at the frame of one slider.
export function sceneView(place, data) {
  if (!place || data.scenes.length === 0) return;
  const view = parts(data);
  const webgl = hasWebgl();
  if (!webgl) {
    view.flat.checked = true;
    view.flat.disabled = true;
    view.note.textContent = 'This browser draws no 3D (it has no WebGL), so the run is shown from above.';
  }
  let run = null;
  let scene = null;
  let fixed = 0;
  let beside = null;

  // The frame of the same number in the run beside.
  function showBeside(frame) {
    if (!beside) return;
    const there = beside.run.frames.indexOf(run.frames[frame]);
    view.other.words.replaceChildren(...(there < 0 ? ['this run does not have the frame'] : wordsAt(beside.run, there))
      .map((text) => element('li', {}, text)));
    if (there >= 0) showImage(view.other, beside.run, beside.scene, there);
  }

  function show(frame) {
    const flat = view.flat.checked;
    const moving = tracesAt(run, frame, flat);
    const each = (name) => moving.map((trace) => trace[name]);
    const update = { x: each('x'), y: each('y'), text: each('text'), hovertext: each('hovertext'), 'marker.color': moving.map((trace) => trace.marker?.color) };
    if (!flat) update.z = each('z');
    window.Plotly.restyle(view.plot, update, moving.map((_, i) => fixed + i));
    window.Plotly.relayout(view.errors, { shapes: cursor(run.times_ms[frame] / 1000) });
    showImage(view, run, scene, frame);
    showBeside(frame);
    const words = wordsAt(run, frame);
    view.words.replaceChildren(...words.map((text) => element('li', {}, text)));
    view.plot.setAttribute('aria-label', `${flat ? 'View from above' : '3D view'} of ${runName(scene, data)} at frame ${run.frames[frame]}. ${words.join('; ')}.`);
    place.dataset.frame = String(run.frames[frame]);
  }

  const slider = player((frame) => { if (run) show(frame); });

  function drawRun(frame) {
    const flat = view.flat.checked;
    const still = fixedTraces(run, flat);
    fixed = still.length;
    window.Plotly.newPlot(view.plot, [...still, ...tracesAt(run, frame, flat)], sceneLayout(run, flat, view.plot.clientWidth), CONFIG);
    window.Plotly.newPlot(view.errors, errorTraces(run, run.frames.map((_, i) => cameraError(run, i))), errorLayout(), CONFIG);
    view.errors.setAttribute('aria-label', `Position errors of camera and objects over time of ${runName(scene, data)}`);
    const count = run.frames.length;
    slider.start(count, (i) => `frame ${run.frames[i]} (${i + 1} of ${count}), ${(run.times_ms[i] / 1000).toFixed(2)} s`, frame);
  }

  function chooseBeside() {
    const index = view.beside.value;
    beside = index === '' ? null : { run: prepared(Number(index)), scene: data.scenes[Number(index)] };
    view.other.side.hidden = !beside;
    view.grid.classList.toggle('two', Boolean(beside));
    if (beside) view.other.name.textContent = runName(beside.scene, data);
  }

  function chooseRun() {
    scene = data.scenes[Number(view.choice.value)];
    run = prepared(Number(view.choice.value));
    offerBeside(view, data, Number(view.choice.value));
    chooseBeside();
    view.all.replaceChildren(...(scene.images_folder
      ? [element('a', { href: `${scene.images_folder}/` }, 'Every frame of this run, larger')] : []));
    if (webgl) view.note.textContent = scene.missing.join(' ');
    if (run.frames.length === 0) {
      view.note.textContent = 'This run has no frames.';
      return;
    }
    drawRun(Math.floor(run.frames.length / 2));
  }

  const slide = slider.row;
  arrange(place, view, slide);
  view.choice.addEventListener('change', chooseRun);
  view.beside.addEventListener('change', () => {
    chooseBeside();
    drawRun(Number(slide.querySelector('input').value));
  });
  view.flat.addEventListener('change', () => drawRun(Number(slide.querySelector('input').value)));
  const observer = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    observer.disconnect();
    chooseRun();
  }, { rootMargin: '200px' });
  observer.observe(place);
}
