// Random impacts with a fixed seed.

import { dot, times } from '../src/vector.js';

export const sequence = seed => {
  let state = seed >>> 0;
  return () => { // mulberry32
    state = (state + 0x6d2b79f5) >>> 0;
    let word = Math.imul(state ^ (state >>> 15), state | 1);
    word ^= word + Math.imul(word ^ (word >>> 7), word | 61);
    return ((word ^ (word >>> 14)) >>> 0) / 2 ** 32;
  };
};

export const vectorOf = (next, size = 1) => Array.from({ length: 3 }, () => size * (2 * next() - 1));

const sphere = next => {
  const radius = 10 ** (-3 * next());
  return {
    mass: 10 ** (4 * next() - 3),
    radius,
    inertia: [0.4, 2 / 3, 0.35 + next() * (2 / 3 - 0.35)][Math.floor(3 * next())],
    velocity: vectorOf(next, 5),
    spin: vectorOf(next, 10 / radius),
  };
};

/** An impact; its bodies approach each other. */
export const impactOf = next => {
  const impact = {
    body1: sphere(next),
    normal: vectorOf(next, 3),
    poisson: 1.4 * next() - 0.9,
    friction: next() < 0.05 ? 0 : 10 ** (4 * next() - 3),
    restitution: next() < 0.5 ? 1 : next(),
  };
  if (next() < 0.6) impact.body2 = sphere(next);
  const other = impact.body2 ? impact.body2.velocity : [0, 0, 0];
  const approach = dot(other, impact.normal) - dot(impact.body1.velocity, impact.normal);
  return approach > 0 ? impact : { ...impact, normal: times(impact.normal, -1) };
};
