// Against the library, which follows each impact step by step without this table.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { kappaOf, rebound, rx, rxOfGroups } from '../src/index.js';
import { norm } from '../src/vector.js';

const reference = JSON.parse(readFileSync(new URL('reference.json', import.meta.url), 'utf8'));
const GREATEST = 1e-8; // the accuracy of the table of elastic impacts
const LOSSY = 3e-3; // and of that with a loss
const MEAN = 2e-4;

const difference = (a, b) => norm(a.map((part, i) => part - b[i]));
const solved = ({ body2, kind, ...given }) => rebound(body2 ? { ...given, body2 } : given);

// Off by so much of the greatest speed in the impact; a spin counts by the speed of the surface.
const miss = (given, found, after) => {
  const bodies = [given.body1, given.body2].filter(Boolean);
  const speed = Math.max(...bodies.map((body, i) => Math.max(
    norm(body.velocity), body.radius * norm(body.spin), norm(after.velocities[i]), body.radius * norm(after.spins[i]),
  )));
  return Math.max(...bodies.flatMap((body, i) => [
    difference(found.velocities[i], after.velocities[i]) / speed,
    body.radius * difference(found.spins[i], after.spins[i]) / speed,
  ]));
};

test('velocities, spins and R_x are those of the library', () => {
  const [elastic, lossy] = [true, false].map(isElastic => {
    const cases = reference.cases.filter(({ given }) => (given.restitution === 1) === isElastic && given.restitution >= 0.1);
    const misses = cases.map(({ given, after }) => [miss(given, solved(given), after), Math.abs(solved(given).rx - after.rx)]);
    const [motion, rx] = [0, 1].map(k => Math.max(...misses.map(both => both[k])));
    console.log(`${cases.length} impacts: R_x off by at most ${rx.toExponential(1)}, `
      + `velocities and spins by ${motion.toExponential(1)} of the greatest speed`);
    return { count: cases.length, motion, rx, mean: misses.reduce((sum, both) => sum + both[1], 0) / cases.length };
  });
  assert.ok(elastic.count >= 100 && lossy.count >= 100);
  assert.ok(elastic.motion < GREATEST && elastic.rx < GREATEST);
  assert.ok(lossy.motion < LOSSY && lossy.rx < LOSSY && lossy.mean < MEAN);
});

test('the cases are of every kind', () => {
  const count = kind => reference.cases.filter(({ given }) => given.kind === kind).length;
  for (const kind of ['sticking', 'partial slip', 'sticking ends', 'slides first', 'border', 'sliding']) {
    assert.ok(count(kind) >= 50, kind);
  }
  const some = holds => reference.cases.filter(({ given }) => holds(given)).length;
  assert.ok(some(({ body1 }) => body1.inertia > 0.66) >= 50);
  assert.ok(some(({ body1, body2 }) => body2 && body1.mass > 10 * body2.mass) >= 50);
  assert.ok(some(({ body2 }) => !body2) >= 50);
  const slides = reference.cases.filter(({ given }) => given.kind === 'border' && solved(given).slides).length;
  assert.ok(slides > 20 && slides < 60);
});

test('R_x of the groups is that of the library', () => {
  const misses = reference.groups.map(([chi, psi, exact]) => Math.abs(rxOfGroups(chi, psi) - exact));
  console.log(`${misses.length} pairs of chi and psi: R_x off by at most ${Math.max(...misses).toExponential(1)}`);
  assert.ok(Math.max(...misses) < GREATEST);
});

test('closed forms', () => {
  // Sliding throughout, R_x = -1 + 2 chi/psi; nu = 0 without slip, R_x = 1 - 2 u^2 by Gauss's theorem.
  assert.equal(rx(1, 7), 0);
  assert.equal(rx(1.2, 100), 7 / 1.2 / (100 / 1.2) - 1);
  assert.ok(Math.abs(rx(1, 0) + 0.3869845664727078) < GREATEST);
  assert.ok(Math.abs(rxOfGroups(1, 0) - 1) < GREATEST); // the release retraces the loading
  assert.equal(rx(1, Infinity), -1);
  assert.equal(kappaOf(0), 1);
  assert.equal(kappaOf(0.5), 1.5);
});

test('R_x is that of the groups', () => {
  const [kappa, lambda, inertia] = [1.3, 2.1, 0.6];
  assert.equal(rx(kappa, lambda, inertia), rxOfGroups((1 + 1 / inertia) / kappa, lambda / kappa));
});
