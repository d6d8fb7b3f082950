// SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
// SPDX-License-Identifier: Apache-2.0
import { element } from '../element.js';

const still = window.matchMedia('(prefers-reduced-motion: reduce)');
const STEP_MS = 120;
const CALM_STEP_MS = 1000;

// A slider over frames with a button that plays them. Calls show(frame) at most once per picture.
export function player(show) {
  const button = element('button', { type: 'button', class: 'play' }, 'Play');
  const slider = element('input', { type: 'range', min: 0, max: 0, value: 0, step: 1, 'aria-label': 'Frame' });
  const text = element('output', { class: 'time' });
  let timer = null;
  let asked = false;
  let describe = () => '';

  function draw() {
    asked = false;
    const frame = Number(slider.value);
    text.textContent = describe(frame);
    slider.setAttribute('aria-valuetext', text.textContent);
    show(frame);
  }
  function ask() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
  }
  function stop() {
    clearInterval(timer);
    timer = null;
    button.textContent = 'Play';
  }
  function step() {
    if (Number(slider.value) >= Number(slider.max)) stop();
    else {
      slider.value = String(Number(slider.value) + 1);
      ask();
    }
  }
  button.addEventListener('click', () => {
    if (timer !== null) {
      stop();
      return;
    }
    if (slider.value === slider.max) slider.value = '0';
    button.textContent = 'Pause';
    timer = setInterval(step, still.matches ? CALM_STEP_MS : STEP_MS);
  });
  slider.addEventListener('input', ask);
  return {
    row: element('div', { class: 'player' }, button, slider, text),
    start(count, describeFrame, frame) {
      stop();
      describe = describeFrame;
      slider.max = String(Math.max(count - 1, 0));
      slider.value = String(Math.min(frame, count - 1));
      draw();
    },
  };
}
