#!/usr/bin/env bash
# Finding: In p2-es a body that is made of several shapes gets the inertia of all its mass from each of them: cut into four, the same bar is four times as hard to turn. p2, from which it comes, is right.
# Package: p2-es 1.2.3 (npm), p2 0.7.1 (npm)
# Expected: The shapes share the mass, so that a bar of two halves has the inertia of the bar, 5/12 m for 1 by 2, and a push beside its centre turns both alike.
# Seen: 0.4167 in one piece, 0.8333 in two and 1.6667 in four, where p2 has 0.4167 for all; the push gives 1.2, 0.6 and 0.3 rad/s. An L from `fromPolygon`, which cuts it by itself, has twice its inertia too.
# Touches carom: The spin after an oblique impact follows from m R2 over the inertia: set `inertia` of such a body by hand before the rebound is compared with carom's.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y > npm.log
npm install --no-audit --no-fund --silent p2-es@1.2.3 p2@0.7.1 >> npm.log
cat > parts.mjs <<'JAVASCRIPT'
import { readFileSync } from 'node:fs';
import p2 from 'p2';
import * as p2es from 'p2-es';
for (const name of ['p2-es', 'p2']) console.log(name, JSON.parse(readFileSync(`node_modules/${name}/package.json`)).version);
const CORNERS = [[-1, -1], [1, -1], [1, 0], [0, 0], [0, 1], [-1, 1]];

// A bar of 1 by 2 and mass 1 in equal parts, one above the other.
function bar(engine, parts) {
  const body = new engine.Body({ mass: 1, damping: 0, angularDamping: 0 });
  for (let part = 0; part < parts; part++) {
    body.addShape(new engine.Box({ width: 1, height: 2 / parts }), [0, -1 + (part + 0.5) * 2 / parts]);
  }
  return body;
}

// Spin after a push of 1 N s half a metre beside the centre.
function spin(engine, parts) {
  const world = new engine.World({ gravity: [0, 0] });
  const body = bar(engine, parts);
  world.addBody(body);
  body.applyImpulse([0, 1], [0.5, 0]);
  world.step(1 / 60);
  return body.angularVelocity;
}

// Inertia about the centre of an L of mass 1, of two rectangles of 2 by 1 and 1 by 1.
function ell(engine) {
  const body = new engine.Body({ mass: 1 });
  body.fromPolygon(CORNERS.map((corner) => [...corner]));
  return body.inertia;
}

const [LONG, SHORT] = [2 / 3, 1 / 3];  // masses; centres at (0, -0.5) and (-0.5, 0.5)
const centre = [SHORT * -0.5, LONG * -0.5 + SHORT * 0.5];
const away = (x, y) => (x - centre[0]) ** 2 + (y - centre[1]) ** 2;
const rightEll = LONG * (5 / 12 + away(0, -0.5)) + SHORT * (1 / 6 + away(-0.5, 0.5));
let fault = false;
for (const [name, engine, factor] of [['p2-es', p2es, (parts) => parts], ['p2', p2, () => 1]]) {
  for (const parts of [1, 2, 4]) {
    const [inertia, turns] = [bar(engine, parts).inertia, spin(engine, parts)];
    console.log(`${name}, bar in ${parts}: expected inertia ${(5 / 12).toFixed(4)} and 1.2000 rad/s, seen ${inertia.toFixed(4)} and ${turns.toFixed(4)} rad/s`);
    fault ||= Math.abs(inertia / (factor(parts) * 5 / 12) - 1) > 1e-6 || Math.abs(turns * factor(parts) / 1.2 - 1) > 1e-6;
  }
  const seen = ell(engine);
  console.log(`${name}, L from its outline: expected ${rightEll.toFixed(4)}, seen ${seen.toFixed(4)}`);
  fault ||= Math.abs(seen / (factor(2) * rightEll) - 1) > 1e-6;
}
process.exit(fault ? 1 : 0);
JAVASCRIPT
node parts.mjs
