// SPDX-License-Identifier: Apache-2.0
// The page's controls. All that is computed and drawn is litfog's, in WebAssembly: apps/browser/main.cpp.
'use strict';

const byId = (id) => document.getElementById(id);
const picture = byId('picture');
const kModes = {none: -1, exp: 0, exp2: 1};

const state =
    {mode: 'exp', visibility: 150, contrast: 0.05, light: 'airlight', exposure: 'fixed', ev: 0, tone: 'neutral'};
const text = (pointer) => UTF8ToString(pointer);
const numbers = (pointer, count) => Array.from(HEAPF64.subarray(pointer / 8, pointer / 8 + count));

// Four digits, as people write them.
function short(value) {
  if (!Number.isFinite(value)) return '∞';
  const rounded = Number(value.toPrecision(4));
  return Math.abs(rounded) < 1e-3 && rounded !== 0 ? rounded.toExponential() : String(rounded);
}

// --- Sliders: a fraction of the way between two ends, on a logarithmic scale where the low end is above 0. Where the
// scale begins with zero, its first hundredth is 0. ---
const kFirst = 0.01;

function valueAt(fraction, {low, high, linear, zero}) {
  if (linear) return low + fraction * (high - low);
  if (zero && fraction < kFirst) return 0;
  return low * Math.pow(high / low, fraction);
}
function fractionOf(value, {low, high, linear, zero}) {
  if (linear) return (value - low) / (high - low);
  if (zero && value < low) return 0;
  return Math.min(Math.max(Math.log(value / low) / Math.log(high / low), zero ? kFirst : 0), 1);
}

// A row of a name, a slider and its value. `changed` gets a value of four digits.
function makeSlider(id, name, scale, changed) {
  const row = document.createElement('label');
  row.className = 'row slider';
  row.innerHTML = '<span></span><input type="range" min="0" max="1" step="any"><output></output>';
  const [label, input, output] = row.children;
  label.textContent = name;
  input.id = id;
  input.addEventListener('input', () => {
    const value = valueAt(input.valueAsNumber, scale);
    const step = scale.step ?? 0;
    changed(step ? Math.round(value / step) * step : Number(value.toPrecision(4)));
  });
  return {
    row,
    show(value) {
      input.value = fractionOf(value, scale);
      output.textContent = (scale.words?.(value) ?? short(value)) + (Number.isFinite(value) ? scale.unit ?? '' : '');
    },
  };
}

// --- What stands in the address, so that it opens this picture again. ---
const kNumbers = ['visibility', 'contrast', 'ev'];
const kWords = {mode: Object.keys(kModes), light: ['airlight', 'peak'], exposure: ['fixed', 'auto'],
                tone: ['neutral', 'clip']};
const kMembers =
    ['red', 'green', 'blue', 'constant', 'linear', 'quadratic', 'threshold', 'radius', 'profile', 'first', 'second'];
const kProfileAt = kMembers.indexOf('profile');
const kParameterAt = kProfileAt + 1;  // of a cone
let profiles = [];  // of cones
let lamps = [];  // {name, members, original}
let firstCamera = [];

function address() {
  const items = Object.entries(state).map(([name, value]) => `${name}=${value}`);
  const camera = numbers(_page_camera(), 6).map((value) => Number(value.toFixed(3)));
  if (String(camera) !== String(firstCamera)) items.push(`camera=${camera}`);
  lamps.forEach((lamp, i) => {
    if (String(lamp.members) !== String(lamp.original)) items.push(`lamp${i}=${lamp.members}`);
  });
  if (document.body.classList.contains('bare')) items.push('controls=off');
  return '#' + items.join('&');
}

// What the address says that makes no sense is left as it is.
function readAddress() {
  for (const item of location.hash.slice(1).split('&')) {
    const [name, word] = item.replaceAll('%2C', ',').split('=');  // as some programs write a comma
    const list = (word ?? '').split(',').map(Number);
    if (kWords[name]?.includes(word)) state[name] = word;
    if (kNumbers.includes(name) && word && !Number.isNaN(list[0])) state[name] = list[0];
    if (name === 'camera' && list.length === 6 && list.every(Number.isFinite)) _page_set_camera(...list);
    if (name === 'controls') showPanel(word !== 'off');
    const lamp = lamps[name.match(/^lamp(\d+)$/)?.[1]];
    if (lamp && list.length === kMembers.length && profiles[list[kProfileAt]]) setLamp(lamp, list);
  }
  state.visibility = Math.max(state.visibility, 0);
  if (!(state.contrast > 0 && state.contrast < 1)) state.contrast = 0.05;
  state.ev = Math.min(Math.max(state.ev, exposureScale.low), exposureScale.high);
}

// --- Drawing: at once and coarsely where the machine is slow, and at full size when the view is still. ---
let still = 0;  // a timer
let isWaiting = false;

function change() {
  clearTimeout(still);
  still = setTimeout(() => attempt(() => draw(1)), _page_still_after());
  if (!isWaiting) requestAnimationFrame(() => attempt(sketch));
  isWaiting = true;
}

function sketch() {
  isWaiting = false;
  moveByKeys();
  draw(_page_divisor());
}

function draw(divisor) {
  const density = _page_set_fog(kModes[state.mode], state.visibility, state.contrast);
  _page_set_airlight(state.light === 'airlight');
  _page_set_display(state.ev, state.exposure === 'auto' && divisor === 1, state.tone === 'neutral');
  const scale = Math.min(window.devicePixelRatio || 1, 2) / divisor;
  picture.width = Math.max(Math.round(picture.clientWidth * scale), 1);
  picture.height = Math.max(Math.round(picture.clientHeight * scale), 1);
  const milliseconds = _page_draw(picture.width, picture.height, divisor);
  const [surfaces, bytes, ev] = numbers(_page_report(), 3);
  state.ev = ev;
  exposure.show(ev);
  byId('density').textContent = Number.isFinite(density) ? `${short(density)} / m` : 'total fog';
  byId('facts').textContent = `${picture.width} × ${picture.height}, ${milliseconds.toFixed(0)} ms · ` +
      `${surfaces} surfaces · ${bytes} bytes of lamps uploaded`;
  if (divisor > 1) return;
  clearTimeout(still);
  document.body.dataset.drawn = milliseconds.toFixed(1);
  history.replaceState(null, '', address());
}

// --- The panel. ---
function showPanel(isShown) {
  document.body.classList.toggle('bare', !isShown);
  byId('panel').hidden = byId('facts').hidden = !isShown;
  byId('hide').setAttribute('aria-expanded', isShown);
  byId('hide').textContent = isShown ? 'Hide controls' : 'Controls';
}

const visibilityScale = {words: (value) => (value === Infinity ? 'clear' : short(value)), unit: ' m'};
const visibility = makeSlider('visibility', 'Visibility', visibilityScale, (value) => set({visibility: value}));
const exposureScale = {linear: true, step: 0.05, words: (value) => (value > 0 ? '+' : '') + value.toFixed(2)};
const exposure = makeSlider('ev', 'EV', exposureScale, (value) => set({ev: value, exposure: 'fixed'}));

function set(changes) {
  Object.assign(state, changes);
  showState();
  change();
}

function showState() {
  for (const name of Object.keys(kWords)) {
    for (const input of document.getElementsByName(name)) input.checked = input.value === state[name];
  }
  visibility.show(state.visibility);
  exposure.show(state.ev);
  byId('contrast').value = state.contrast;
  byId('fogged').disabled = state.mode === 'none';
  for (const [i, button] of [...byId('presets').children].entries()) {
    button.value = _page_preset_metres(i, kModes[state.mode], state.contrast);
    button.setAttribute('aria-pressed', Number(button.value) === state.visibility);
  }
  _page_set_fog(kModes[state.mode], state.visibility, state.contrast);
  showLamp();
}

// --- Lamps. ---
const kLampScales = {
  constant: ['Constant', {low: 0.01, high: 20, zero: true}],
  linear: ['Linear', {low: 1e-5, high: 10, zero: true, unit: ' / m'}],
  quadratic: ['Quadratic', {low: 1e-6, high: 10, zero: true, unit: ' / m²'}],
  threshold: ['Threshold', {low: 0.001, high: 0.9}],
};
let picked = 0;
let rows = {};

const member = (lamp, name) => lamp.members[kMembers.indexOf(name)];

// The members of a light file. One without a cone is a point light.
function membersOf({color, attenuation: {constant, linear, quadratic}, threshold, source_radius_m = 0,
                    cone = {profile: 'none'}}) {
  const profile = profiles.findIndex(({name}) => name === cone.profile);
  const [first = 0, second = 0] = profiles[profile].parameters.map(({file}) => cone[file]);
  return [...color, constant, linear, quadratic, threshold, source_radius_m, profile, first, second];
}

// Takes the members of a lamp, or says what is wrong with them.
function setLamp(lamp, members) {
  const error = text(_page_set_lamp(lamps.indexOf(lamp), ...members));
  byId('wrong').textContent = error;
  if (!error) lamp.members = members;
}

function changeLamp(changes) {
  const lamp = lamps[picked];
  const members = [...lamp.members];
  for (const [name, value] of Object.entries(changes)) members[kMembers.indexOf(name)] = value;
  setLamp(lamp, members);
  showLamp();
  change();
}

function pickLamp(index) {
  picked = index;
  byId('lamps').selectedIndex = index;
  byId('wrong').textContent = '';
  buildMembers();
  showLamp();
}

// A cone's parameter as kLampScales has other members.
function parameterOf({label, isAngle, ends: [low, high]}, i) {
  const scale = isAngle ? {low, high, linear: true, unit: '°'} : {low: low || high / 50000, high, zero: low === 0};
  return [kMembers[kParameterAt + i], [label, scale]];
}

function buildMembers() {
  const lamp = lamps[picked];
  const profile = profiles[member(lamp, 'profile')];
  rows = {};
  const add = ([name, [label, scale]]) => {
    rows[name] = makeSlider(name, label, scale, (value) => changeLamp({[name]: value}));
    return rows[name].row;
  };
  const cone = document.createElement('label');
  cone.className = 'row';
  cone.innerHTML = '<span>Cone</span><select id="cone"></select>';
  for (const each of profiles) cone.lastChild.add(new Option(each.name, each.name, false, each === profile));
  cone.lastChild.addEventListener('change', (event) => {
    const changes = {profile: event.target.selectedIndex};
    kMembers.slice(kParameterAt).forEach((key, i) => {
      changes[key] = profiles[changes.profile].parameters[i]?.first ?? 0;
    });
    changeLamp(changes);
    buildMembers();
    showLamp();
  });
  rows.brightness = makeSlider('brightness', 'Brightness', {low: 0.001, high: 1000}, (value) => {
    const [red, green, blue] = hueOf(lamp).map((part) => Number((part * value).toPrecision(4)));
    changeLamp({red, green, blue});
  });
  byId('members').replaceChildren(...Object.entries(kLampScales).map(add), cone,
                                  ...profile.parameters.map(parameterOf).map(add), rows.brightness.row);
}

// A colour's parts over the largest of them.
function hueOf(lamp) {
  const rgb = lamp.members.slice(0, 3);
  const largest = Math.max(...rgb);
  return largest > 0 ? rgb.map((part) => part / largest) : [1, 1, 1];
}

function showLamp() {
  const lamp = lamps[picked];
  for (const [name, row] of Object.entries(rows)) {
    row.show(name === 'brightness' ? Math.max(...lamp.members.slice(0, 3)) : member(lamp, name));
  }
  byId('hue').value =
      '#' + hueOf(lamp).map((part) => Math.round(255 * _page_srgb(part)).toString(16).padStart(2, '0')).join('');
  byId('reset').disabled = String(lamp.members) === String(lamp.original);
  drawCurve();
}

// --- The solve as a curve over the range from the lamp. ---
function tickStep(whole) {
  const power = Math.pow(10, Math.floor(Math.log10(whole / 4)));
  const times = whole / 4 / power;
  return power * (times < 1.5 ? 1 : times < 3.5 ? 2 : times < 7.5 ? 5 : 10);
}

function drawCurve() {
  const pointer = _page_curve(picked);
  const [intensity, peak, extent, knee, end, count] = numbers(pointer, 6);
  const samples = numbers(pointer + 48, 3 * count);
  const canvas = byId('curve');
  const scale = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  canvas.width = width * scale;
  canvas.height = height * scale;
  const pen = canvas.getContext('2d');
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue(name);
  pen.scale(scale, scale);
  pen.font = '11px system-ui, sans-serif';
  const box = {left: 36, right: width - 8, top: 8, bottom: height - 20};
  const top = intensity > 0 ? intensity * 1.6 : 1;
  const x = (range) => box.left + (box.right - box.left) * range / end;
  const y = (value) => box.bottom - (box.bottom - box.top) * value / top;
  const line = (from, to) => {
    pen.beginPath();
    pen.moveTo(...from);
    pen.lineTo(...to);
    pen.stroke();
  };
  pen.strokeStyle = colour('--line');
  pen.fillStyle = colour('--faint');
  pen.textAlign = 'center';
  for (let range = 0; range <= end; range += tickStep(end)) {
    line([x(range), box.top], [x(range), box.bottom]);
    pen.fillText(range === 0 ? '0 m' : short(range), x(range), height - 5);
  }
  pen.textAlign = 'right';
  for (let value = 0; value <= top; value += tickStep(top)) {
    line([box.left, y(value)], [box.right, y(value)]);
    if (value > 0) pen.fillText(short(value), box.left - 5, y(value) + 4);
  }
  pen.save();
  pen.beginPath();
  pen.rect(box.left, box.top, box.right - box.left, box.bottom - box.top);
  pen.clip();
  [['--cool', 0, 1.2], ['--green', 1, 1.2], ['--accent', 2, 2]].forEach(([name, which, weight]) => {
    pen.strokeStyle = colour(name);
    pen.lineWidth = weight;
    pen.beginPath();
    for (let i = 0; i < count; ++i) pen.lineTo(x(end * i / (count - 1)), y(samples[3 * i + which]));
    pen.stroke();
  });
  pen.restore();
  if (intensity > 0 && Number.isFinite(peak)) {
    pen.fillStyle = colour('--accent');
    pen.beginPath();
    pen.arc(x(peak), y(intensity), 3.5, 0, 2 * Math.PI);
    pen.fill();
  }
  const kneeText = knee > 0 ? `, knee ${short(knee)} m` : '';
  byId('solve').innerHTML = '<b class="product">light in fog (1 − f) a</b>, <b class="opacity">opacity 1 − f</b>, ' +
      `<b class="attenuation">attenuation a</b><br>peak ${short(intensity)} at ${short(peak)} m, extent ${short(extent)} m${kneeText}`;
}

// --- The camera. ---
const held = new Set();  // keys
const pointers = new Map();
let movedAt = 0;

// Moves by what is held.
function moveByKeys() {
  const now = performance.now();
  const seconds = Math.min((now - movedAt) / 1000, 0.1);
  movedAt = now;
  const step = seconds * (held.has('shift') ? 20 : 4);
  const axis = (ahead, back) => (held.has(ahead) - held.has(back)) * step;
  const [right, up, ahead] = [axis('d', 'a'), axis('e', 'q'), axis('w', 's')];
  if (right === 0 && up === 0 && ahead === 0) return;
  _page_fly(right, up, ahead);
  change();
}

function listenToCamera() {
  picture.addEventListener('pointerdown', (event) => {
    pointers.set(event.pointerId, event);
    picture.setPointerCapture(event.pointerId);
  });
  const forget = (event) => pointers.delete(event.pointerId);
  picture.addEventListener('pointerup', forget);
  picture.addEventListener('pointercancel', forget);
  picture.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const other = [...pointers.values()].find((each) => each.pointerId !== event.pointerId);
    const distance = (from) => Math.hypot(from.clientX - other.clientX, from.clientY - other.clientY);
    if (other) {
      _page_approach(Math.max(distance(before), 1) / Math.max(distance(event), 1));
    } else {
      const degrees = 0.18;  // a pixel
      const [right, up] = [event.clientX - before.clientX, before.clientY - event.clientY];
      const flies = document.querySelector('[name="drag"]:checked').value === 'fly';
      (flies ? _page_look : _page_orbit)(-right * degrees, -up * degrees);
    }
    pointers.set(event.pointerId, event);
    change();
  });
  picture.addEventListener('wheel', (event) => {
    event.preventDefault();
    _page_approach(Math.pow(1.0015, event.deltaY));
    change();
  }, {passive: false});
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches('select')) return;
    if (!held.size) movedAt = performance.now();
    if (!'wasdqe'.includes(event.key.toLowerCase()) && event.key !== 'Shift') return;
    held.add(event.key.toLowerCase());
    change();
  });
  window.addEventListener('keyup', (event) => held.delete(event.key.toLowerCase()));
  window.addEventListener('blur', () => held.clear());
}

function listen() {
  for (const name of Object.keys(kWords)) {
    for (const input of document.getElementsByName(name)) {
      input.addEventListener('change', () => set({[name]: input.value}));
    }
  }
  byId('contrast').addEventListener('change', (event) => set({contrast: Number(event.target.value)}));
  byId('lamps').addEventListener('change', (event) => pickLamp(event.target.selectedIndex));
  byId('hue').addEventListener('input', (event) => {
    const brightest = Math.max(...lamps[picked].members.slice(0, 3));
    const rgb = [1, 3, 5].map((at) => _page_linear(parseInt(event.target.value.slice(at, at + 2), 16) / 255));
    const largest = Math.max(...rgb) || 1;
    const [red, green, blue] = rgb.map((part) => Number((part / largest * brightest).toPrecision(4)));
    changeLamp({red, green, blue});
  });
  byId('reset').addEventListener('click', () => {
    setLamp(lamps[picked], [...lamps[picked].original]);
    pickLamp(picked);
    change();
  });
  byId('back').addEventListener('click', () => {
    _page_set_camera(...firstCamera);
    change();
  });
  byId('hide').addEventListener('click', () => {
    showPanel(byId('panel').hidden);
    change();
  });
  byId('panel').addEventListener('submit', (event) => event.preventDefault());
  new ResizeObserver(change).observe(picture);
  window.addEventListener('hashchange', () => {
    readAddress();
    showState();
    change();
  });
  listenToCamera();
}

// --- The beginning. ---
function say(sentence) {
  byId('note').textContent = sentence;
  byId('note').hidden = !sentence;
}

function fail(error) {
  // An exception of C++ is the number of its address.
  say(typeof error === 'number' ? `This page cannot draw: ${text(_page_what(error))}.` : `This page failed: ${error}`);
  byId('panel').hidden = true;
  byId('hide').hidden = true;
}

function begin() {
  _page_open();
  firstCamera = numbers(_page_camera(), 6).map((value) => Number(value.toFixed(3)));
  Object.assign(visibilityScale, {low: _page_least_visibility(), high: _page_most_visibility()});
  Object.assign(exposureScale, {low: -_page_largest_exposure(), high: _page_largest_exposure()});
  for (let i = 0; i < _page_preset_count(); ++i) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = text(_page_preset_name(i));
    button.title = text(_page_preset_meaning(i));
    button.addEventListener('click', () => set({visibility: Number(button.value)}));
    byId('presets').append(button);
  }
  profiles = JSON.parse(text(_page_profiles()));
  for (let i = 0; i < _page_lamp_count(); ++i) {
    const light = kLights[text(_page_lamp_file(i))];
    lamps.push({original: membersOf(light)});
    setLamp(lamps[i], lamps[i].original);
    const copies = _page_lamp_copies(i);
    byId('lamps').add(new Option(light.name + (copies > 1 ? ` × ${copies}` : '')));
  }
  byId('fogged').prepend(visibility.row);
  byId('display').append(exposure.row);
  byId('panel').hidden = false;
  readAddress();
  pickLamp(0);
  showState();
  listen();
  say('');
  draw(_page_divisor());
  document.body.dataset.begun = performance.now().toFixed(0);
  change();
}

// One material a task, so that the page stays alive.
function paint() {
  const left = _page_paint();
  say(left > 0 ? `Painting the street: ${left} materials left` : 'Drawing');
  setTimeout(left > 0 ? () => attempt(paint) : () => attempt(begin), 0);
}

function attempt(action) {
  try {
    action();
  } catch (error) {
    fail(error);
  }
}

var Module = {
  onRuntimeInitialized: () => attempt(paint),
  onAbort: (what) => fail(what),
};
if (typeof WebAssembly !== 'object' || !document.createElement('canvas').getContext('webgl2')) {
  say('This page needs WebGL 2 and WebAssembly, which this browser does not have or has switched off.');
  Module = {noInitialRun: true, onRuntimeInitialized() {}};
}
