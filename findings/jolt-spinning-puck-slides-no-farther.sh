#!/usr/bin/env bash
# Finding: In Jolt a disc or a box that spins on the floor slides as if it did not spin, and spins as if it did not slide.
# Package: jolt-physics 1.1.0 (npm)
# Expected: Coulomb's friction is bounded at each point and acts against the motion of that point; the faster a puck spins, the less is left against its slide: at 30 m/s of the rim a tenth.
# Seen: The whole friction f m g acts against the slide and at the same time the whole f m g times the radius of the rim against the spin, at any spin and step.
# Touches carom: carom shares the friction of a patch between slide and twist. Compare with Jolt only where there is no spin about the normal, or for a ball.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent jolt-physics@1.1.0 >> npm.log
cat > puck.mjs <<'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import start from 'jolt-physics';
const jolt = await start();
console.log('jolt-physics', JSON.parse(readFileSync('node_modules/jolt-physics/package.json')).version);
const [FRICTION, GRAVITY, RADIUS, HALF_HEIGHT, SPEED, TIME] = [0.3, 10, 0.5, 0.2, 3, 0.3];
const settings = new jolt.JoltSettings();
const pairs = new jolt.ObjectLayerPairFilterTable(2);
pairs.EnableCollision(0, 1);
const layers = new jolt.BroadPhaseLayerInterfaceTable(2, 2);
for (const layer of [0, 1]) layers.MapObjectToBroadPhaseLayer(layer, new jolt.BroadPhaseLayer(layer));
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
const world = new jolt.JoltInterface(settings);
const system = world.GetPhysicsSystem();
const bodies = system.GetBodyInterface();
const vector = (x, y, z) => new jolt.Vec3(x, y, z);
system.SetGravity(vector(0, -GRAVITY, 0));

function add(shape, height, moves) {
  const motion = moves ? jolt.EMotionType_Dynamic : jolt.EMotionType_Static;
  const made = new jolt.BodyCreationSettings(shape, new jolt.RVec3(0, height, 0), jolt.Quat.prototype.sIdentity(), motion, moves ? 1 : 0);
  Object.assign(made, { mFriction: FRICTION, mRestitution: 0, mLinearDamping: 0, mAngularDamping: 0, mMaxAngularVelocity: 200, mAllowSleeping: false });
  const id = bodies.CreateBody(made).GetID();
  bodies.AddBody(id, jolt.EActivation_Activate);
  return id;
}

// Speed and spin of a puck after TIME.
function slide(shape, spin, step) {
  const puck = add(shape, HALF_HEIGHT, true);
  bodies.SetLinearVelocity(puck, vector(SPEED, 0, 0));
  bodies.SetAngularVelocity(puck, vector(0, spin, 0));
  for (let count = 0; count < Math.round(TIME / step); count++) world.Step(step, 1);
  const after = [bodies.GetLinearVelocity(puck).GetX(), bodies.GetAngularVelocity(puck).GetY()];
  bodies.RemoveBody(puck);
  bodies.DestroyBody(puck);
  return after;
}

// The same by Coulomb's law at each point of a disc whose pressure is even.
function coulomb(spin) {
  let speed = SPEED;
  const [rings, spokes, steps] = [12, 24, 600];
  for (let count = 0; count < steps; count++) {
    let [force, torque] = [0, 0];
    for (let point = 0; point < rings * spokes; point++) {
      const distance = RADIUS * Math.sqrt((Math.floor(point / spokes) + 0.5) / rings);
      const angle = (2 * Math.PI * ((point % spokes) + 0.5)) / spokes;
      const [x, y] = [distance * Math.cos(angle), distance * Math.sin(angle)];
      const slip = [speed - spin * y, spin * x];
      const pull = (FRICTION * GRAVITY) / (rings * spokes) / (Math.hypot(...slip) || 1);
      force -= pull * slip[0];
      torque -= pull * (x * slip[1] - y * slip[0]);
    }
    speed += (force * TIME) / steps;
    spin += ((torque * TIME) / steps) * (2 / RADIUS ** 2);
  }
  return [speed, spin];
}

add(new jolt.BoxShape(vector(50, 0.5, 50), 0.05), -0.5, false);
let fault = false;
for (const [name, make] of [['disc', () => new jolt.CylinderShape(HALF_HEIGHT, RADIUS, 0.01)], ['box', () => new jolt.BoxShape(vector(RADIUS, HALF_HEIGHT, RADIUS), 0.01)]]) {
  for (const [spin, step] of [[0, 1 / 60], [20, 1 / 60], [60, 1 / 60], [60, 1 / 480]]) {
    const [speed, left] = slide(make(), spin, step);
    const law = coulomb(spin);
    console.log(`${name}, ${spin} rad/s, step 1/${Math.round(1 / step)} s: 3 m/s after ${TIME} s: expected ${law[0].toFixed(3)} m/s` +
      `${name === 'disc' ? `, ${law[1].toFixed(2)} rad/s` : ' or so'}; seen ${speed.toFixed(3)} m/s, ${left.toFixed(2)} rad/s`);
    fault ||= Math.abs(speed - (SPEED - FRICTION * GRAVITY * TIME)) > 0.005;
    fault ||= name === 'disc' && spin > 0 && Math.abs(left - (spin - (2 * FRICTION * GRAVITY * TIME) / RADIUS)) > 0.02;
  }
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node puck.mjs
