#!/usr/bin/env bash
# Finding: In p2 a ball of restitution 1 bounces well at coarse steps and not at all at steps of half a millisecond; with finer ones it bounces again, whatever its restitution.
# Package: p2 0.7.1 (npm), p2-es 1.2.3 (npm)
# Expected: Smaller time steps bring the rebound nearer to e v, as they bring everything else nearer to its limit.
# Seen: 3 m/s and e = 1 give 2.99 m/s at 1/60 s, 2.53 at 1/600, 0.09 at 1/2000 and 2.14 at 1/20000 s; e = 0.5 gives 1.50, 1.15, 0.01 and 2.16. No gravity, no friction, no damping; both packages to the last digit.
# Touches carom: A convergence test against a rebound by carom fails for the reason of the steps: use 1/60 s, or raise `stiffness` with the square of the number of steps.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent p2@0.7.1 p2-es@1.2.3 >> npm.log
cat > steps.mjs <<'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import p2 from 'p2';
import * as p2es from 'p2-es';
for (const name of ['p2', 'p2-es']) console.log(name, JSON.parse(readFileSync(`node_modules/${name}/package.json`)).version);
const SPEED = 3;

// Velocity away from the floor 0.2 s after the start, some 0.18 s after the bounce.
function rebound(engine, restitution, steps, scaled) {
  const world = new engine.World({ gravity: [0, 0] });
  const material = new engine.Material();
  const contact = { friction: 0, restitution };
  if (scaled) contact.stiffness = 1e6 * (steps / 60) ** 2;
  world.addContactMaterial(new engine.ContactMaterial(material, material, contact));
  const shape = new engine.Circle({ radius: 0.5 });
  const ball = new engine.Body({ mass: 1, position: [0, 0.55], velocity: [0, -SPEED], damping: 0, angularDamping: 0 });
  const plane = new engine.Plane();
  const floor = new engine.Body({ mass: 0 });
  shape.material = plane.material = material;
  ball.addShape(shape);
  floor.addShape(plane);
  world.addBody(ball);
  world.addBody(floor);
  for (let step = 0; step < 0.2 * steps; step++) world.step(1 / steps);
  return ball.velocity[1];
}

let fault = false;
for (const [restitution, stated] of [[1, [2.995, 2.531, 0.091, 2.144]], [0.5, [1.496, 1.149, 0.009, 2.156]]]) {
  [60, 600, 2000, 20000].forEach((steps, place) => {
    const [seen, other, stiff] = [rebound(p2, restitution, steps, false), rebound(p2es, restitution, steps, false), rebound(p2, restitution, steps, true)];
    console.log(`e ${restitution}, step 1/${steps} s: expected ${(restitution * SPEED).toFixed(3)} m/s, seen ${seen.toFixed(3)}, p2-es ${other.toFixed(3)}; with scaled stiffness ${stiff.toFixed(3)} m/s`);
    fault ||= Math.abs(seen - stated[place]) > 0.01 || Math.abs(other - stated[place]) > 0.01 || Math.abs(stiff - restitution * SPEED) > 0.03;
  });
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node steps.mjs
