#!/usr/bin/env bash
# Finding: In pocket-physics the number for the mass of two equal balls decides how they rebound: 1 and 1 are elastic, 2 and 2 stick together, 4 and 4 pass through each other, 0.5 and 0.5 gain energy fivefold.
# Package: pocket-physics 11.0.0 (npm)
# Expected: A central collision depends on the ratio of the masses alone, so kilograms and pounds give the same speeds; without damping it keeps the energy.
# Seen: The momentum is kept always, and the restitution of equal balls is 2 / m - 1; of unequal ones 1 / m1 + 1 / m2 - 1, which is right for 2 and 2/3 too, as for every pair whose reciprocals add up to 2.
# Touches carom: Scale the masses so that the sum of their reciprocals is 1 + e before such a collision is compared with an impact of restitution e by carom.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent pocket-physics@11.0.0 >> npm.log
cat > balls.cjs <<'JAVASCRIPT'
const { readFileSync } = require('node:fs');
const { collideCircleCircle, inertia } = require('pocket-physics');
console.log('pocket-physics', JSON.parse(readFileSync('node_modules/pocket-physics/package.json')).version);
const [RADIUS, SPEED] = [1, 0.01];

// Speeds along x, in units of the first, after the first ball has met the second, which rests.
function collide(mass1, mass2) {
  const ball = (x, step) => ({ cpos: { x, y: 0 }, ppos: { x: x - step, y: 0 }, acel: { x: 0, y: 0 } });
  const [first, second] = [ball(0, SPEED), ball(2 * RADIUS + 2.5 * SPEED, 0)];
  for (let step = 0; step < 20; step++) {
    const apart = second.cpos.x - first.cpos.x;
    if (apart < 2 * RADIUS && first.cpos.x - first.ppos.x > second.cpos.x - second.ppos.x) {
      collideCircleCircle(first, RADIUS, mass1, second, RADIUS, mass2, true, 1);
      return [first, second].map((one) => (one.cpos.x - one.ppos.x) / SPEED);
    }
    inertia(first);
    inertia(second);
  }
  throw new Error('the balls did not meet');
}

let fault = false;
for (const [mass1, mass2] of [[1, 1], [0.5, 0.5], [2, 2], [4, 4], [2, 2 / 3], [1, 2], [10, 20]]) {
  const [u1, u2] = collide(mass1, mass2);
  const right = [(mass1 - mass2) / (mass1 + mass2), 2 * mass1 / (mass1 + mass2)];
  const energy = (mass1 * u1 ** 2 + mass2 * u2 ** 2) / mass1;
  const stated = 1 / mass1 + 1 / mass2 - 1;
  const show = (x) => x.toFixed(3);
  console.log(`masses ${show(mass1)} and ${show(mass2)}: expected speeds ${right.map(show)}, energy 1; seen ${show(u1)},${show(u2)}, energy ${show(energy)}, restitution ${show(u2 - u1)}`);
  fault ||= Math.abs(u2 - u1 - stated) > 1e-9 || Math.abs(mass1 * u1 + mass2 * u2 - mass1) > 1e-9 * mass1;
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node balls.cjs
