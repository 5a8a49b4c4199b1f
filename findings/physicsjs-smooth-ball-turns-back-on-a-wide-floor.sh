#!/usr/bin/env bash
# Finding: In physicsjs a smooth ball that lands obliquely on a wide floor turns back: it keeps its energy, but gets a spin that no friction gave it and flies off to where it came from.
# Package: physicsjs 0.7.0 (npm)
# Expected: Without friction the speed along the floor stays and there is no spin; restitution 1 reverses the speed across it. A ball of radius 10 that comes down slowly on the same floor does just that.
# Seen: A ball of radius 1 with (1, 0.5) on a floor 1000 wide leaves with -0.35 along the floor and a spin of 1.35; one of radius 10 with (0.2, 0.2) with -0.006 along and half its speed up. Its contact on the level floor has a normal along the floor.
# Touches carom: Look at the normals of the contacts before an oblique impact is compared with carom's; the energy does not tell.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent physicsjs@0.7.0 >> npm.log
cat > land.cjs <<'JAVASCRIPT'
const Physics = require('physicsjs');
console.log('physicsjs', require('physicsjs/package.json').version);

// Speeds of a smooth ball after its landing on the level middle of a fixed floor; y points down, times are in ms.
function land(radius, along, down, width) {
  let state;
  const normals = [];
  Physics({ timestep: 6 }, (world) => {
    const surface = { mass: 1, restitution: 1, cof: 0 };
    const ball = Physics.body('circle', { x: 0, y: -2 - radius, vx: along, vy: down, radius, ...surface });
    const floor = Physics.body('rectangle', { x: 0, y: 5, width, height: 10, treatment: 'static', ...surface });
    world.add([ball, floor, Physics.behavior('body-impulse-response'), Physics.behavior('body-collision-detection'), Physics.behavior('sweep-prune')]);
    world.on('collisions:detected', ({ collisions }) => collisions.forEach(({ norm }) => normals.push(Math.abs(norm.x))));
    for (let step = 0; step <= 60; step++) world.step(1000 + 6 * step);
    state = { along: ball.state.vel.x, up: -ball.state.vel.y, spin: ball.state.angular.vel, moment: ball.moi };
  });
  return { ...state, tilt: Math.max(...normals) };
}

let fault = false;
for (const [radius, along, down, width, wrong] of [
  [1, 0, 0.5, 1000, false], [10, 1, 0.05, 1000, false], [10, 0.2, 0.05, 1000, false],
  [1, 1, 0.5, 1000, true], [1, 0.2, 0.05, 1000, true], [10, 0.2, 0.2, 1000, true], [10, 1, 0.5, 1000, true],
]) {
  const seen = land(radius, along, down, width);
  const energy = (seen.along ** 2 + seen.up ** 2 + seen.moment * seen.spin ** 2) / (along ** 2 + down ** 2);
  console.log(`radius ${radius}, (${along}, ${down}): expected ${along} along, ${down} up, no spin; seen ${seen.along.toFixed(4)} along, `
    + `${seen.up.toFixed(4)} up, spin ${seen.spin.toFixed(4)}, energy times ${energy.toFixed(3)}, normal along the floor ${seen.tilt.toFixed(4)}`);
  const kept = Math.abs(seen.along - along) < 1e-3 && Math.abs(seen.up - down) < 1e-3 && Math.abs(seen.spin) < 1e-3;
  fault ||= kept === wrong || (wrong && seen.tilt < 0.8);
}
const back = land(1, 1, 0.5, 1000);
fault ||= Math.abs(back.along + 0.351) > 0.01 || Math.abs(back.spin - 1.351) > 0.01;
process.exit(fault ? 1 : 0);
JAVASCRIPT
node land.cjs
