// R_x(chi, psi) of an elastic impact, from the table that the library carom stores.
//
// The plane of chi and psi is cut where R_x has kinks. Each region is a square of 4 by 4 cells, halved until a
// polynomial of degree 7 in both directions fits. The file table-data.js has the layout of the table in the library.

import { data } from './table-data.js';

const ORDER = 8;
const CELLS = 4;
/** The range of chi in which every cell has a polynomial and R_x follows from it. */
export const CHI = [1, 5.25];
const CHI_END = 6.5;
const [STICK_BACK, STICK_FORTH, SLIDE_BACK, SLIDE_FORTH, SLIDE_FAR, SLIDE_SLIP] = [1, 2, 3, 4, 5, 6];
const [LEAF, ACROSS_CHI, ACROSS_PSI] = [1, 2, 3];

/** The bytes of a text in base 64. */
export const decoded = text => {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i += 1) bytes[i] = letters.charCodeAt(i);
  return new DataView(bytes.buffer);
};

const read = view => {
  let at = 0;
  const number = () => { at += 8; return view.getFloat64(at - 8, true); };
  const word = () => { at += 4; return view.getUint32(at - 4, true); };
  const integer = () => { at += 4; return view.getInt32(at - 4, true); };
  const [stick, slide] = [0, 1].map(() => Float64Array.from({ length: ORDER }, number));
  const far = number();
  const [nodes, leaves] = [word(), word()];
  const tree = Uint32Array.from({ length: nodes }, word);
  const coefficients = new Float64Array(leaves * ORDER * ORDER);
  for (let leaf = 0; leaf < leaves; leaf += 1) {
    const first = leaf * ORDER * ORDER;
    coefficients[first] = number();
    const unit = number(); // the others are whole multiples of it
    for (let i = 1; i < ORDER * ORDER; i += 1) coefficients[first + i] = unit * integer();
  }
  return { stick, slide, far, tree, coefficients };
};

let kept = null;
const table = () => {
  kept = kept ?? read(decoded(data));
  return kept;
};

// T_0 to T_7.
const chebyshev = x => {
  const values = new Float64Array(ORDER);
  values[0] = 1;
  values[1] = x;
  for (let k = 2; k < ORDER; k += 1) values[k] = 2 * x * values[k - 1] - values[k - 2];
  return values;
};

const onCurve = (curve, t) => chebyshev(2 * t - 1).reduce((sum, value, k) => sum + curve[k] * value, 0);

const fifthRoot = x => {
  if (x <= 0) return 0;
  const root = x ** 0.2;
  return root - (root ** 5 - x) / (5 * root ** 4);
};

// The region of a point and the place in it, both coordinates from 0 to 1.
const locate = ({ stick, slide, far }, chi, psi) => {
  if (psi < 1) {
    const curve = onCurve(stick, psi);
    if (chi < curve) return [STICK_BACK, (chi - 1) / (curve - 1), psi];
    return [STICK_FORTH, (chi - curve) / (CHI_END - curve), psi];
  }
  const whole = (chi - 1) / (CHI_END - 1);
  const share = (psi - 1) / (chi - 1);
  if (psi >= chi) return [SLIDE_SLIP, whole, share - 1];
  if (share >= far) return [SLIDE_FAR, whole, (share - far) / (1 - far)];
  const t = share / far;
  const curve = onCurve(slide, t);
  if (chi < curve) return [SLIDE_BACK, (chi - 1) / (curve - 1), fifthRoot(t)];
  return [SLIDE_FORTH, (chi - curve) / (CHI_END - curve), fifthRoot(t)];
};

// The cell of a coordinate among equal ones and the place in it, from -1 to 1.
const cell = coordinate => {
  const scaled = coordinate * CELLS;
  const index = Math.min(Math.max(Math.trunc(scaled), 0), CELLS - 1);
  return [index, 2 * (scaled - index) - 1];
};

// The half of a halved cell and the place in it.
const half = (first, place) => (place < 0 ? [first, 2 * place + 1] : [first + 1, 2 * place - 1]);

const leafAt = ({ tree }, region, x, y) => {
  const [column, fromChi] = cell(x);
  const [row, fromPsi] = cell(y);
  let [node, u, v] = [region * CELLS * CELLS + column * CELLS + row, fromChi, fromPsi];
  for (;;) {
    const [kind, index] = [tree[node] % 4, tree[node] >>> 2];
    if (kind === LEAF) return [index, u, v];
    if (kind === ACROSS_CHI) [node, u] = half(index, u);
    else if (kind === ACROSS_PSI) [node, v] = half(index, v);
    else return null;
  }
};

const polynomial = ({ coefficients }, leaf, u, v) => {
  const [byChi, byPsi] = [chebyshev(u), chebyshev(v)];
  let sum = 0;
  for (let row = 0; row < ORDER; row += 1) {
    let line = 0;
    for (let column = 0; column < ORDER; column += 1) {
      line += coefficients[(leaf * ORDER + row) * ORDER + column] * byChi[column];
    }
    sum += line * byPsi[row];
  }
  return sum;
};

/** Whether an impact slides from first contact to separation: psi >= 2 chi - 1, for chi >= 1. */
export const slidesThroughout = (chi, psi) => psi >= 2 * chi - 1;

/** R_x for chi in `CHI` and psi >= 0. */
export const restitution = (chi, psi) => {
  if (slidesThroughout(chi, psi)) return 2 * chi / psi - 1;
  const all = table();
  const found = leafAt(all, ...locate(all, chi, psi));
  return Math.min(Math.max(polynomial(all, ...found), -1), 1);
};
