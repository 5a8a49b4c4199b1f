#!/usr/bin/env bash
# Finding: In goblinphysics friction does not know the load: a block of 1000 kg is braked by as many newtons as one of 10 kg, so that a heavy block slides on nearly for ever.
# Package: goblinphysics 0.9.2 (npm)
# Expected: A block that slides on a level floor with the coefficient 0.3 slows down with 0.3 g = 2.94 m/s2, whatever its mass.
# Seen: It slows down with 1.13 m/s2 at 10 kg, 0.107 m/s2 at 100 kg and 0.0101 m/s2 at 1000 kg: 10 to 11 N each. The limit of friction is the coefficient times a constant, not times the force of the contact.
# Touches carom: Its coefficient of friction is no Coulomb coefficient; use none of its slides or oblique impacts beside those of carom.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent goblinphysics@0.9.2 >> npm.log
cat > slide.cjs <<'JAVASCRIPT'
const Goblin = require('goblinphysics');
console.log('goblinphysics', require('goblinphysics/package.json').version);
const G = 9.81;
const STEP = 1 / 240;
const SPEED = 10; // m/s

// Mean deceleration over one second of a block on a wide fixed floor.
function slide(mass, friction) {
  const world = new Goblin.World(new Goblin.SAPBroadphase(), new Goblin.NarrowPhase(), new Goblin.IterativeSolver());
  world.gravity.set(0, -G, 0);
  const floor = new Goblin.RigidBody(new Goblin.BoxShape(1000, 0.5, 1000), Infinity);
  const block = new Goblin.RigidBody(new Goblin.BoxShape(0.5, 0.25, 0.5), mass);
  floor.position.y = -0.5;
  block.position.y = 0.25;
  for (const body of [floor, block]) {
    body.friction = friction;
    body.restitution = 0;
    world.addRigidBody(body);
  }
  for (let i = 0; i < 480; i++) world.step(STEP);
  block.linear_velocity.x = SPEED;
  for (let i = 0; i < 240; i++) world.step(STEP);
  return { slowing: SPEED - block.linear_velocity.x, height: block.position.y };
}

let fault = false;
const force = {};
for (const friction of [0, 0.3, 0.6]) {
  for (const mass of [10, 100, 1000]) {
    const seen = slide(mass, friction);
    const expected = friction * G;
    force[`${friction} ${mass}`] = mass * seen.slowing;
    console.log(`coefficient ${friction}, ${mass} kg: expected ${expected.toFixed(3)} m/s2, ${(mass * expected).toFixed(1)} N; `
      + `seen ${seen.slowing.toFixed(4)} m/s2, ${(mass * seen.slowing).toFixed(2)} N, centre ${seen.height.toFixed(3)} m high`);
    fault ||= Math.abs(seen.height - 0.25) > 0.01;
    if (friction === 0) fault ||= Math.abs(seen.slowing) > 1e-6;
    else fault ||= seen.slowing > 0.4 * expected * (10 / mass) || seen.slowing <= 0;
  }
}
for (const friction of [0.3, 0.6]) {
  const ratio = force[`${friction} 1000`] / force[`${friction} 10`];
  console.log(`coefficient ${friction}: friction of 1000 kg over that of 10 kg: expected 100, seen ${ratio.toFixed(2)}`);
  fault ||= Math.abs(ratio - 1) > 0.3;
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node slide.cjs
