// SPDX-License-Identifier: Apache-2.0
// Two of the pictures lie on top of each other; `state` says which, and how they are shown. The address may hold a
// state: index.html#a=0&b=2&mode=wipe&wipe=0.3&zoom=8&x=640&y=360
const byId = (id) => document.getElementById(id);
const stage = byId('stage'), layers = byId('layers');
const state = {
  a: 0,
  b: 1,
  mode: 'wipe',
  wipe: 0.5,
  zoom: 0,
  x: width / 2,
  y: height / 2
};  // zoom 0: as large as fits
const modes = ['a', 'b', 'wipe', 'difference'];

const pairOf = (a, b) => differences.find((each) => each.first === Math.min(a, b) && each.second === Math.max(a, b));
const fitting = () => Math.min(stage.clientWidth / width, stage.clientHeight / height);
const scale = () => state.zoom || fitting();
const origin = () => {
  const centre = state.zoom ? [state.x, state.y] : [width / 2, height / 2];
  return [stage.clientWidth / 2 - centre[0] * scale(), stage.clientHeight / 2 - centre[1] * scale()];
};

// A position in the window relative to the stage's corner, within its border.
function within(clientX, clientY) {
  const box = stage.getBoundingClientRect();
  return [clientX - box.left - stage.clientLeft, clientY - box.top - stage.clientTop];
}

function show() {
  const [left, top] = origin();
  const pair = pairOf(state.a, state.b);
  const edge = state.wipe * stage.clientWidth;
  layers.style.width = width + 'px';
  layers.style.height = height + 'px';
  layers.style.transform = `translate(${left}px, ${top}px) scale(${scale()})`;
  layers.classList.toggle('pixels', scale() >= 1);
  for (const [id, source] of [
           ['under', pictures[state.a]], ['over', pictures[state.b]], ['heat', pair && pair.picture]]) {
    const picture = byId(id);
    if (source && picture.getAttribute('src') !== source) picture.src = source;
  }
  byId('under').alt = names[state.a];
  byId('over').alt = names[state.b];
  byId('over').style.visibility = state.mode === 'b' || state.mode === 'wipe' ? 'visible' : 'hidden';
  byId('over').style.clipPath =
      state.mode === 'wipe' ? `inset(0 0 0 ${Math.max(0, (edge - left) / scale())}px)` : 'none';
  byId('heat').style.visibility = state.mode === 'difference' && pair ? 'visible' : 'hidden';
  byId('edge').style.left = edge + 'px';
  document.body.classList.toggle('wiping', state.mode === 'wipe');
  document.body.classList.toggle('difference', state.mode === 'difference');
  for (const button of document.querySelectorAll('[data-mode]')) {
    button.setAttribute('aria-pressed', String(button.dataset.mode === state.mode));
  }
  byId('a').value = state.a;
  byId('b').value = state.b;
  byId('wipe').value = state.wipe;
  byId('zoom').value = `${Number(scale().toPrecision(3))} \u00d7`;
  byId('pair').value =
      pair ? `Largest difference ${pair.largest}, mean ${pair.mean} of 1/255` : 'The same setting twice';
}

// Zooms by powers of two; the picture's point under the pointer stays where it is.
function zoomBy(step, clientX, clientY) {
  const [left, top] = origin();
  const at = clientX === undefined ? [stage.clientWidth / 2, stage.clientHeight / 2] : within(clientX, clientY);
  const point = [(at[0] - left) / scale(), (at[1] - top) / scale()];
  const rounded = step > 0 ? Math.floor(Math.log2(scale()) + 1e-9) + 1 : Math.ceil(Math.log2(scale()) - 1e-9) - 1;
  const next = Math.min(Math.pow(2, rounded), 64);
  state.zoom = next <= fitting() ? 0 : next;
  state.x = point[0] - (at[0] - stage.clientWidth / 2) / next;
  state.y = point[1] - (at[1] - stage.clientHeight / 2) / next;
  show();
}

const flip = () => {
  state.mode = state.mode === 'a' ? 'b' : 'a';
  show();
};

// The pictures' channel values. The page embeds its pictures, so browsers let it read them from a disk, too.
const texels = new Map();
function valueAt(index, x, y) {
  if (!texels.has(index)) {
    texels.set(index, null);  // until it is decoded
    const image = new Image();
    image.onload = () => {
      const canvas = Object.assign(document.createElement('canvas'), {width, height});
      texels.set(index, canvas.getContext('2d', {willReadFrequently: true}));
      texels.get(index).drawImage(image, 0, 0);
    };
    image.src = pictures[index];
  }
  return texels.get(index) ? [...texels.get(index).getImageData(x, y, 1, 1).data].slice(0, 3) : ['\u2026'];
}

function showPixel(event) {
  const [left, top] = origin(), at = within(event.clientX, event.clientY);
  const x = Math.floor((at[0] - left) / scale());
  const y = Math.floor((at[1] - top) / scale());
  const isInside = x >= 0 && y >= 0 && x < width && y < height;
  byId('pixel').value =
      isInside ? `pixel ${x}, ${y}: A ${valueAt(state.a, x, y).join(' ')}, B ${valueAt(state.b, x, y).join(' ')}` : '';
}

// What is dragged: the wipe's edge, or the pictures.
let drag = null;
const wipeTo = (clientX) => {
  state.wipe = Math.min(Math.max(within(clientX, 0)[0] / stage.clientWidth, 0), 1);
};
stage.addEventListener('pointerdown', (event) => {
  const fromEdge = within(event.clientX, 0)[0] - state.wipe * stage.clientWidth;
  const isEdge = state.mode === 'wipe' && Math.abs(fromEdge) < 12;
  drag = {x: event.clientX, y: event.clientY, moved: false, isEdge};
  stage.setPointerCapture(event.pointerId);
});
stage.addEventListener('pointermove', (event) => {
  showPixel(event);
  if (!drag) return;
  const [dx, dy] = [event.clientX - drag.x, event.clientY - drag.y];
  if (!drag.moved && Math.hypot(dx, dy) < 4) return;
  if (drag.isEdge) {
    wipeTo(event.clientX);
  } else if (state.zoom) {
    state.x -= dx / scale();
    state.y -= dy / scale();
  }
  drag = {x: event.clientX, y: event.clientY, moved: true, isEdge: drag.isEdge};
  show();
});
stage.addEventListener('pointerup', (event) => {
  if (drag && !drag.moved) {
    if (state.mode === 'wipe') {
      wipeTo(event.clientX);
      show();
    } else {
      flip();
    }
  }
  drag = null;
});
stage.addEventListener('pointercancel', () => {
  drag = null;
});
stage.addEventListener('wheel', (event) => {
  event.preventDefault();
  if (event.deltaY === 0) return;  // scrolled sideways
  zoomBy(event.deltaY < 0 ? 1 : -1, event.clientX, event.clientY);
}, {passive: false});

for (const id of ['a', 'b'])
  byId(id).addEventListener('change', (event) => {
    state[id] = Number(event.target.value);
    show();
  });
for (const button of document.querySelectorAll('[data-mode]')) {
  button.addEventListener('click', () => {
    state.mode = button.dataset.mode;
    show();
  });
}
byId('wipe').addEventListener('input', (event) => {
  state.wipe = Number(event.target.value);
  show();
});
byId('in').addEventListener('click', () => zoomBy(1));
byId('out').addEventListener('click', () => zoomBy(-1));
byId('fit').addEventListener('click', () => {
  state.zoom = 0;
  show();
});
setInterval(() => {
  if (byId('blink').checked) flip();
}, 600);

document.addEventListener('keydown', (event) => {
  if (event.target.matches('select, input') || event.ctrlKey || event.metaKey || event.altKey) return;
  const mode = {a: 'a', b: 'b', w: 'wipe', d: 'difference'}[event.key.toLowerCase()];
  if (mode) {
    state.mode = mode;
    show();
  } else if (event.key === ' ' && !event.target.matches('button')) {
    event.preventDefault();
    flip();
  } else if (event.key === '+')
    zoomBy(1);
  else if (event.key === '-')
    zoomBy(-1);
  else if (event.key === '0') {
    state.zoom = 0;
    show();
  }
});
window.addEventListener('resize', show);

const address = new URLSearchParams(location.hash.slice(1));
for (const key of ['a', 'b']) {
  const index = Number(address.get(key) ?? state[key]);
  if (index in pictures) state[key] = index;
}
for (const [key, least, most] of [['wipe', 0, 1], ['zoom', 0, 64], ['x', 0, width], ['y', 0, height]]) {
  const number = Number(address.get(key) ?? state[key]);
  if (number >= least && number <= most) state[key] = number;
}
if (modes.includes(address.get('mode'))) state.mode = address.get('mode');
show();
