#!/usr/bin/env bash
# Finding: In Rapier the friction of a bounce is that of the approach alone, as if the ball did not rebound; planck (Box2D 2) has it right.
# Package: @dimforge/rapier3d-compat 0.21.0 (npm), planck 1.4.2 (npm)
# Expected: Coulomb's law bounds the tangential impulse by f times the whole normal impulse, (1 + e) m v; a sliding ball loses f (1 + e) v.
# Seen: At f = 0.2, e = 0.8, v = 3 m/s the ball loses 0.600 = f v in Rapier and 1.080 = f (1 + e) v in planck; that it bounces by e does not show in the friction.
# Touches carom: The door to Rapier replaces the friction of a first contact and so gives the whole impulse; contacts that it leaves to Rapier keep the error.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent @dimforge/rapier3d-compat@0.21.0 planck@1.4.2 >> npm.log
cat > slide.mjs <<'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import RAPIER from '@dimforge/rapier3d-compat';
import { Box, Circle, World } from 'planck';
await RAPIER.init();
const planckVersion = JSON.parse(readFileSync('node_modules/planck/package.json')).version;
console.log('@dimforge/rapier3d-compat', RAPIER.version(), 'planck', planckVersion);
const [FRICTION, NORMAL, TANGENTIAL] = [0.2, 3, 6];

// Each gives the speed that is lost along the floor and the speed of the rebound.
function rapier(restitution) {
  const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
  const surface = (shape) => shape.setFriction(FRICTION).setRestitution(restitution);
  const ball = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 1, 0).setLinvel(TANGENTIAL, -NORMAL, 0));
  world.createCollider(surface(RAPIER.ColliderDesc.ball(0.5)), ball);
  const floor = world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
  world.createCollider(surface(RAPIER.ColliderDesc.cuboid(50, 0.5, 50).setTranslation(0, -0.5, 0)), floor);
  for (let step = 0; step < 60; step++) world.step();
  return [TANGENTIAL - ball.linvel().x, ball.linvel().y];
}
function planck(restitution) {
  const world = new World({ gravity: { x: 0, y: 0 } });
  const surface = { density: 1, friction: FRICTION, restitution };
  const ball = world.createDynamicBody({ position: { x: 0, y: 1 }, linearVelocity: { x: TANGENTIAL, y: -NORMAL } });
  ball.createFixture({ shape: new Circle(0.5), ...surface });
  world.createBody().createFixture({ shape: new Box(50, 1, { x: 0, y: -1 }), ...surface });
  for (let step = 0; step < 60; step++) world.step(1 / 60);
  return [TANGENTIAL - ball.getLinearVelocity().x, ball.getLinearVelocity().y];
}

let fault = false;
for (const e of [0.2, 0.5, 0.8]) {
  const [a, b] = [rapier(e), planck(e)];
  const [approach, whole] = [FRICTION * NORMAL, FRICTION * (1 + e) * NORMAL];
  console.log(`e ${e}: expected loss ${whole.toFixed(3)}; Rapier ${a[0].toFixed(3)} (rebound ${a[1].toFixed(2)}), planck ${b[0].toFixed(3)} (rebound ${b[1].toFixed(2)})`);
  const off = [a[0] - approach, b[0] - whole, a[1] - e * NORMAL, b[1] - e * NORMAL];
  fault ||= off.some((x) => Math.abs(x) > 1e-3);
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node slide.mjs
