// R_x(chi, psi, e) of an impact of a viscous material, from the table that the library carom stores.
//
// For each restitution below 1 a grid over chi and psi, in two blocks: up to psi = 1, and from there to the border of
// sliding throughout. Interpolation is cubic in all three, with each restitution at the same part of its block; at e = 1
// the table of elastic impacts takes part.

import { losses } from './table-data.js';
import { decoded, restitution as elastic } from './table.js';

const NODES = [0.99, 0.98, 0.95, 0.9, 0.85, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1];
const RANGE = [0.66, 6.5];
const CHIS = 25;
// Nodes of psi up to 1, and beyond.
const PSIS = 17;
const PSIS_BEYOND = 33;
const ROW = PSIS + PSIS_BEYOND;

let kept = null;
const table = () => {
  kept = kept ?? decoded(losses);
  return kept;
};

/** psi from which an impact slides from first contact to separation, for chi >= 1. */
export const border = (chi, e) => Math.max(chi * (1 + e) - e, 1);

// Cubic weights of nodes at 0, 1, 2, ...: the first of four, and the weights.
const evenly = (at, count) => {
  const first = Math.min(Math.max(Math.trunc(at) - 1, 0), count - 4);
  const t = at - first;
  const [a, b, c, d] = [t, t - 1, t - 2, t - 3];
  return [first, [-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6]];
};

const ofE = e => {
  const nodes = [1, ...NODES];
  const below = NODES.filter(node => node >= e).length;
  const first = Math.min(Math.max(below - 1, 0), NODES.length - 3);
  const weight = k => [0, 1, 2, 3].filter(other => other !== k).reduce((product, other) =>
    product * (e - nodes[first + other]) / (nodes[first + k] - nodes[first + other]), 1);
  return [first, [0, 1, 2, 3].map(weight)];
};

const sliding = (chi, psi, e) => chi * (1 + e) / psi - 1;

// R_x at one restitution of the table, at a part of the way from psi = 1 to sliding throughout.
const at = (loss, chi, psi, part) => {
  const along = Math.log(chi / RANGE[0]) / Math.log(RANGE[1] / RANGE[0]);
  const [column, byChi] = evenly(along * (CHIS - 1), CHIS);
  const [block, place, count] = psi < 1 ? [0, psi, PSIS] : [PSIS, part, PSIS_BEYOND];
  const [row, byPsi] = evenly(place * (count - 1), count);
  let sum = 0;
  for (let i = 0; i < 4; i += 1) {
    for (let j = 0; j < 4; j += 1) {
      const index = (loss * CHIS + column + i) * ROW + block + row + j;
      sum += byChi[i] * byPsi[j] * table().getFloat32(4 * index, true);
    }
  }
  return sum;
};

/** R_x for chi in `CHI`, psi >= 0 and the restitution e; below e = 0.1 R_x goes straight to that of bodies that rest. */
export const restitution = (chi, psi, e) => {
  if (e === 1) return elastic(chi, psi);
  if (psi >= border(chi, e)) return sliding(chi, psi, e);
  const least = NODES[NODES.length - 1];
  if (e < least) {
    const rests = Math.min(chi / psi - 1, 0);
    return rests + e / least * (restitution(chi, psi, least) - rests);
  }
  const part = psi < 1 ? 0 : (psi - 1) / (border(chi, e) - 1);
  const elasticPsi = psi < 1 ? psi : 1 + part * (border(chi, 1) - 1);
  const [first, weights] = ofE(e);
  return weights.reduce((sum, weight, k) =>
    sum + weight * (first + k === 0 ? elastic(chi, elasticPsi) : at(first + k - 1, chi, psi, part)), 0);
};
