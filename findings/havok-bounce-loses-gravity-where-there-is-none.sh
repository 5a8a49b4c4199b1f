#!/usr/bin/env bash
# Finding: In Havok every rebound of restitution 1 is slower by 9.81 m/s2 times the step, also in a world whose gravity is zero.
# Package: @babylonjs/havok 1.3.14 (npm)
# Expected: Without gravity, friction and damping a ball leaves a wall with restitution times its speed, whatever the step.
# Seen: At 1/60 s a ball of 1 m/s leaves a side wall with 0.8365 and one of 10 m/s with 9.8365 m/s; restitution 0.5 loses half as much; a ball of 0.1 m/s stays at the wall.
# Touches carom: Whoever compares carom's rebounds with Havok adds e 9.81 m/s2 times the step to Havok's; carom knows no gravity in an impact.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent @babylonjs/havok@1.3.14 >> npm.log
cat > wall.mjs <<'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import start from '@babylonjs/havok';
const library = 'node_modules/@babylonjs/havok';
const havok = await start({ wasmBinary: readFileSync(`${library}/lib/esm/HavokPhysics.wasm`) });
console.log('@babylonjs/havok', JSON.parse(readFileSync(`${library}/package.json`)).version);
const NONE = [0, 0, 0];
const UPRIGHT = [0, 0, 0, 1];

// Speed along x after a ball of 1 kg and radius 0.5 m met a fixed wall at right angles, in a world without gravity.
function rebound(speed, restitution, step) {
  const world = havok.HP_World_Create()[1];
  havok.HP_World_SetGravity(world, NONE);
  havok.HP_World_SetIdealStepTime(world, step);
  const add = (shape, x, motion) => {
    const mean = havok.MaterialCombine.ARITHMETIC_MEAN;
    havok.HP_Shape_SetMaterial(shape, [0, 0, restitution, mean, mean]);
    const body = havok.HP_Body_Create()[1];
    havok.HP_Body_SetShape(body, shape);
    havok.HP_Body_SetMotionType(body, motion);
    havok.HP_Body_SetQTransform(body, [[x, 0, 0], UPRIGHT]);
    havok.HP_World_AddBody(world, body, false);
    return body;
  };
  const ball = add(havok.HP_Shape_CreateSphere(NONE, 0.5)[1], 0, havok.MotionType.DYNAMIC);
  havok.HP_Body_SetMassProperties(ball, [NONE, 1, [0.1, 0.1, 0.1], UPRIGHT]);
  havok.HP_Body_SetLinearDamping(ball, 0);
  havok.HP_Body_SetAngularDamping(ball, 0);
  havok.HP_Body_SetLinearVelocity(ball, [speed, 0, 0]);
  add(havok.HP_Shape_CreateBox(NONE, UPRIGHT, [2, 4, 4])[1], 1.501, havok.MotionType.STATIC);
  for (let count = 0; count < 20; count++) havok.HP_World_Step(world, step);
  const after = -havok.HP_Body_GetLinearVelocity(ball)[1][0];
  havok.HP_World_Release(world);
  return after;
}

let fault = false;
for (const step of [1 / 60, 1 / 240]) {
  for (const [speed, restitution] of [[1, 1], [10, 1], [3, 0.5]].concat(step > 0.01 ? [[0.1, 1]] : [])) {
    const seen = rebound(speed, restitution, step);
    const law = Math.max(0, restitution * (speed - 9.81 * step));
    console.log(`step 1/${Math.round(1 / step)} s, speed ${speed} m/s, restitution ${restitution}: expected ${(restitution * speed).toFixed(4)}, ` +
      `seen ${seen.toFixed(4)}, e (v - 9.81 m/s2 step) ${law.toFixed(4)}`);
    fault ||= Math.abs(seen - law) > 2e-3;
  }
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node wall.mjs
