#!/usr/bin/env bash
# Finding: In PhysX with its solver TGS friction throws the slip of a landing ball back twice as fast; with more iterations the ball leaves with more energy than it had.
# Package: physx-js-webidl 2.7.3 (npm), with PhysX 5.6.1
# Expected: Friction stops the slip of a dead ball (restitution 0) and no more: it rolls, R_x = 0, and has 5/14 of its energy left, with both solvers and wherever the step hits.
# Seen: PGS gives R_x from -0.01 to 0.01. TGS at its default iterations gives -0.02 to 2.1 and up to 0.98 of the energy, as the ball begins some mm higher or lower; with 32 iterations -0.32 to 2.6 and 1.31.
# Touches carom: carom's R_x comes of stored energy and friction can only take from it, so it stays below 1. Who compares it with PhysX takes PGS, whose R_x is 0 for a ball that grips.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent physx-js-webidl@2.7.3 >> npm.log
cat > land.mjs <<'JAVASCRIPT'
import { readFileSync } from 'node:fs';
const library = 'node_modules/physx-js-webidl';
const version = JSON.parse(readFileSync(`${library}/package.json`)).version;
// The package is built for browsers: it runs in Node if that does not say its name.
Object.defineProperty(process, 'versions', { value: {} });
globalThis.window = { location: { href: '' } };
globalThis.document = { currentScript: null };
const { default: start } = await import('physx-js-webidl');
const px = await start({ wasmBinary: readFileSync(`${library}/physx-js-webidl.wasm`) });
const top = px.PxTopLevelFunctions.prototype;
const number = top.PHYSICS_VERSION;
console.log('physx-js-webidl', version, 'PhysX', [number >> 24, (number >> 16) & 255, (number >> 8) & 255].join('.'));
const foundation = top.CreateFoundation(number, new px.PxDefaultAllocator(), new px.PxDefaultErrorCallback());
const scale = new px.PxTolerancesScale();
const physics = top.CreatePhysics(number, foundation, scale);
const vector = (x, y, z) => new px.PxVec3(x, y, z);
const [RADIUS, ALONG, DOWN, FRICTION] = [0.5, 3, 3, 1]; // m, m/s

function add(scene, geometry, height, moves) {
  const flags = new px.PxShapeFlags(px.PxShapeFlagEnum.eSCENE_QUERY_SHAPE | px.PxShapeFlagEnum.eSIMULATION_SHAPE);
  const shape = physics.createShape(geometry, physics.createMaterial(FRICTION, FRICTION, 0), true, flags);
  shape.setSimulationFilterData(new px.PxFilterData(1, 1, 0, 0));
  const place = new px.PxTransform(vector(0, height, 0), new px.PxQuat(px.PxIDENTITYEnum.PxIdentity));
  const body = moves ? physics.createRigidDynamic(place) : physics.createRigidStatic(place);
  body.attachShape(shape);
  scene.addActor(body);
  return body;
}

// R_x and the energy, as part of that before, of a ball of 1 kg that lands obliquely on a fixed floor, without gravity.
function land(solver, iterations, step, gap) {
  const made = new px.PxSceneDesc(scale);
  made.set_gravity(vector(0, 0, 0));
  made.set_cpuDispatcher(top.DefaultCpuDispatcherCreate(0));
  made.set_filterShader(top.DefaultFilterShader());
  made.set_solverType(px.PxSolverTypeEnum[`e${solver}`]);
  const scene = physics.createScene(made);
  add(scene, new px.PxBoxGeometry(50, 0.5, 50), -0.5, false);
  const ball = add(scene, new px.PxSphereGeometry(RADIUS), RADIUS + gap, true);
  px.PxRigidBodyExt.prototype.setMassAndUpdateInertia(ball, 1);
  ball.setLinearDamping(0);
  ball.setAngularDamping(0);
  ball.setSolverIterationCounts(iterations, 1);
  ball.setLinearVelocity(vector(ALONG, -DOWN, 0));
  for (let count = 0; count < Math.round(0.3 / step); count++) {
    scene.simulate(step);
    scene.fetchResults(true);
  }
  const { x, y } = ball.getLinearVelocity();
  const rim = ball.getAngularVelocity().z * RADIUS;
  scene.release();
  return [-(x + rim) / ALONG, (x * x + y * y + 0.4 * rim * rim) / (ALONG * ALONG + DOWN * DOWN)];
}

let fault = false;
for (const [solver, iterations, step, least, most] of [
  ['PGS', 4, 1 / 60, 0, 0], ['PGS', 4, 1 / 240, 0, 0],
  ['TGS', 4, 1 / 60, -0.05, 1.05], ['TGS', 4, 1 / 240, -0.05, 2.07], ['TGS', 32, 1 / 240, -0.32, 2.56],
]) {
  const seen = Array.from({ length: 16 }, (_, k) => land(solver, iterations, step, 0.03 + (3 * step * k) / 16));
  const [low, high] = [Math.min(...seen.map(([slip]) => slip)), Math.max(...seen.map(([slip]) => slip))];
  const energy = Math.max(...seen.map(([, part]) => part));
  console.log(`${solver}, ${iterations} iterations, step 1/${Math.round(1 / step)} s, 16 heights: expected R_x 0.00 and ${(5 / 14).toFixed(2)} of the energy; ` +
    `seen R_x ${low.toFixed(2)} to ${high.toFixed(2)}, up to ${energy.toFixed(2)} of the energy`);
  const margin = solver === 'PGS' ? 0.03 : 0.2;
  fault ||= Math.abs(low - least) > margin || Math.abs(high - most) > margin || (iterations === 32 && energy < 1.1);
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node land.mjs
