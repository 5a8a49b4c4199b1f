// What is refused, with a message that names field, value and range.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { InputError, kappaOf, rebound, rx, rxOfGroups } from '../src/index.js';

const good = { body1: { mass: 1, radius: 0.03, velocity: [1, 0, -2] }, poisson: 0.3, friction: 0.2 };
const ball = parts => ({ ...good, body1: { ...good.body1, ...parts } });

const refused = [
  [ball({ mass: 0 }), 'body1.mass = 0 must be a number from 1e-100 to 1e100'],
  [ball({ mass: 1e-308 }), 'body1.mass = 1e-308 must be a number from 1e-100 to 1e100'],
  [ball({ mass: Infinity }), 'body1.mass = Infinity must be a number from 1e-100 to 1e100'],
  [ball({ radius: '3' }), 'body1.radius = "3" must be a number from 1e-100 to 1e100'],
  [ball({ inertia: 0.3 }), 'body1.inertia = 0.3 must be from 0.35 to 2/3 (0.4 solid, 2/3 a thin shell)'],
  [ball({ velocity: [1, 2] }), 'body1.velocity = 1,2 must be an array [x, y, z]'],
  [ball({ spin: [0, NaN, 0] }), 'body1.spin[1] = NaN must be a number of at most 1e100'],
  [ball({ speed: 1 }), 'body1.speed = 1 must be left out; body1 has mass, radius, inertia, velocity, spin'],
  [{ ...good, body1: undefined }, 'body1 = undefined must be an object with mass, radius, inertia, velocity, spin'],
  [{ ...good, body2: null }, 'body2 = null must be an object with mass, radius, inertia, velocity, spin'],
  [{ ...good, body2: { mass: 1, radius: -1 } }, 'body2.radius = -1 must be a number from 1e-100 to 1e100'],
  [{ ...good, normal: [0, 0, 0] }, 'normal = 0,0,0 must be a vector of finite length > 0'],
  [{ ...good, poisson: 0.51 }, 'poisson = 0.51 must be in (-1, 0.5]'],
  [{ ...good, poisson: undefined }, 'poisson = undefined must be in (-1, 0.5]'],
  [{ ...good, friction: -0.1 }, 'friction = -0.1 must be a finite number >= 0'],
  [{ ...good, restitution: 1.1 }, 'restitution = 1.1 must be from 0 to 1'],
  [{ ...good, mu: 0.1 }, 'impact.mu = 0.1 must be left out; impact has body1, body2, normal, poisson, friction, restitution'],
];

test('bad input is refused with field, value and range', () => {
  for (const [given, message] of refused) {
    assert.throws(() => rebound(given), error => {
      assert.ok(error instanceof InputError && error instanceof RangeError);
      assert.equal(error.message, message);
      assert.ok(message.startsWith(error.field) && message.endsWith(error.allowed));
      return true;
    });
  }
  assert.throws(() => rebound(), InputError);
  assert.throws(() => kappaOf(-1), { message: 'poisson = -1 must be in (-1, 0.5]' });
  assert.throws(() => rx(0.7, 1), { message: 'kappa = 0.7 must be in (0.75, 1.5]' });
  assert.throws(() => rx(1, -1), { message: 'lambda = -1 must be >= 0' });
  assert.throws(() => rxOfGroups(5.3, 1), { message: 'chi = 5.3 must be from 1 to 5.25' });
  assert.throws(() => rxOfGroups(2, NaN), { message: 'psi = NaN must be >= 0' });
});

test('the ends of the ranges are allowed', () => {
  for (const inertia of [0.35, 2 / 3]) {
    for (const poisson of [-0.999999, 0.5]) {
      assert.ok(Number.isFinite(rebound({ ...ball({ inertia }), poisson }).rx));
    }
  }
  assert.ok(Number.isFinite(rx(1.5, 0, 2 / 3)));
});

test('what was given is left as it was', () => {
  const given = Object.freeze({ ...good, body1: Object.freeze({ ...good.body1, velocity: Object.freeze([1, 0, -2]) }) });
  rebound(given);
  assert.deepEqual(given, good);
});

test('special cases', () => {
  const apart = rebound(ball({ velocity: [1, 0, 2] }));
  assert.equal(apart.meets, false);
  assert.equal(apart.rx, null);
  assert.deepEqual(apart.velocities[0], [1, 0, 2]);
  const smooth = rebound({ ...good, friction: 0 });
  assert.deepEqual(smooth.velocities[0], [1, 0, 2]);
  assert.equal(smooth.rx, -1);
  const straight = rebound(ball({ velocity: [0, 0, -2] }));
  assert.deepEqual(straight.velocities[0], [0, 0, 2]);
  assert.deepEqual(straight.spins[0], [0, 0, 0]);
  const rolling = rebound({ ...ball({ velocity: new Float64Array([3, 0, -2]), spin: [0, 100, 0] }), friction: 0 });
  assert.deepEqual(rolling.spins[0], [0, 100, 0]);
});
