#!/usr/bin/env bash
# Finding: In cannon-es the friction of a bounce follows from gravity, not from the force of the impact: without gravity a ball bounces as if on ice.
# Package: cannon-es 0.20.0 (npm)
# Expected: The impulse of friction is bounded by f times the normal impulse of the impact, which does not depend on gravity; a sliding sphere loses some f (1 + e) v = 0.9 m/s.
# Seen: At f = 0.2, e = 0.5, v = 3 m/s the loss is 0 without gravity, 0.40 m/s at g = 1 m/s^2 and 0.80 m/s at g = 2 m/s^2, for time steps of 1/60 and 1/600 s alike.
# Touches carom: The JavaScript door `carom-rebound` computes the impact from the speeds alone; people who put it into cannon-es replace this friction by it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent cannon-es@0.20.0 >> npm.log
cat > bounce.mjs <<'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import { Body, ContactMaterial, Material, Plane, Sphere, Vec3, World } from 'cannon-es';
console.log('cannon-es', JSON.parse(readFileSync('node_modules/cannon-es/package.json')).version);
const [FRICTION, RESTITUTION, NORMAL, TANGENTIAL] = [0.2, 0.5, 3, 6];

// Speed that a ball has lost along the floor after its first bounce.
function loss(gravity, timeStep) {
  const world = new World({ gravity: new Vec3(0, -gravity, 0) });
  const material = new Material('ball and floor');
  world.addContactMaterial(new ContactMaterial(material, material, { friction: FRICTION, restitution: RESTITUTION }));
  const ball = new Body({ mass: 1, shape: new Sphere(0.5), material, linearDamping: 0, angularDamping: 0 });
  ball.position.set(0, 0.5 + 1e-6, 0);
  ball.velocity.set(TANGENTIAL, -NORMAL, 0);
  const floor = new Body({ mass: 0, shape: new Plane(), material });
  floor.quaternion.setFromEuler(-Math.PI / 2, 0, 0);
  world.addBody(ball);
  world.addBody(floor);
  for (let step = 0; step < 2000; step++) {
    world.step(timeStep);
    if (ball.velocity.y > 0 && world.contacts.length === 0) break;
  }
  if (!(ball.velocity.y > 0)) throw new Error('the ball did not bounce');
  return TANGENTIAL - ball.velocity.x;
}

let fault = false;
for (const gravity of [0, 1, 2]) {
  const seen = [1 / 60, 1 / 600].map((timeStep) => loss(gravity, timeStep));
  const coulomb = FRICTION * (1 + RESTITUTION) * NORMAL;
  console.log(`g ${gravity}: expected loss ${coulomb.toFixed(2)}, seen ${seen.map((x) => x.toFixed(3))} (steps 1/60, 1/600 s)`);
  fault ||= seen.some((x) => Math.abs(x - 0.4 * gravity) > 1e-3);
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node bounce.mjs
