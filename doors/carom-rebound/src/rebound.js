// Velocities and spins after an oblique impact.

import { InputError, number, object, size, vector } from './check.js';
import { SOLID, inertiaFactor, kappaOf } from './groups.js';
import { border, restitution as ofGroups } from './loss.js';
import { add, cross, dot, norm, times } from './vector.js';

const REST = [0, 0, 0];
const BODY = ['mass', 'radius', 'inertia', 'velocity', 'spin'];
const IMPACT = ['body1', 'body2', 'normal', 'poisson', 'friction', 'restitution'];

// `side` is that of the contact point, seen from the centre: -1 below, +1 above.
const sphere = (field, given, side) => {
  const { mass, radius, inertia = SOLID, velocity = REST, spin = REST } = object(field, given, BODY);
  return {
    side,
    radius: size(`${field}.radius`, radius),
    inertia: inertiaFactor(`${field}.inertia`, inertia),
    inverseMass: 1 / size(`${field}.mass`, mass),
    velocity: vector(`${field}.velocity`, velocity),
    spin: vector(`${field}.spin`, spin),
  };
};

const PLANE = { side: 1, radius: 0, inertia: 1, inverseMass: 0, velocity: REST, spin: REST };

const unit = given => {
  const normal = vector('normal', given);
  const length = norm(normal);
  if (!(length > 0 && Number.isFinite(length))) throw new InputError('normal', given, 'a vector of finite length > 0');
  return times(normal, 1 / length);
};

const read = given => {
  const { body1, body2, normal = [0, 0, 1], poisson, friction, restitution = 1 } = object('impact', given, IMPACT);
  return {
    bodies: [sphere('body1', body1, -1), body2 === undefined ? PLANE : sphere('body2', body2, 1)],
    normal: unit(normal),
    kappa: kappaOf(poisson),
    friction: number('friction', friction, f => f >= 0 && Number.isFinite(f), 'a finite number >= 0'),
    restitution: number('restitution', restitution, e => e >= 0 && e <= 1, 'from 0 to 1'),
  };
};

const atContact = (body, normal) =>
  add(body.velocity, cross(body.spin, times(normal, body.side * body.radius)));

const pushed = (body, normal, impulse) => {
  if (body.inverseMass === 0) return body;
  const turn = times(cross(normal, impulse), body.side * body.inverseMass / (body.inertia * body.radius));
  return { ...body, velocity: add(body.velocity, impulse, body.inverseMass), spin: add(body.spin, turn) };
};

const energy = bodies => bodies.reduce((sum, { inverseMass, radius, inertia, velocity, spin }) => (
  inverseMass === 0 ? sum
    : sum + 0.5 / inverseMass * (dot(velocity, velocity) + inertia * radius ** 2 * dot(spin, spin))
), 0);

// The groups of an impact; without slip and friction psi is that of no friction.
const groupsOf = ({ kappa, friction }, [normalMobility, tangentialMobility], approach, slip) => {
  const lambda = friction === 0 ? Infinity : slip / friction / approach;
  return { kappa, lambda, chi: tangentialMobility / (normalMobility * kappa), psi: lambda / kappa };
};

const answer = (impact, bodies, rest) => ({
  velocities: bodies.map(body => [...body.velocity]),
  spins: bodies.map(body => [...body.spin]),
  energyBefore: energy(impact.bodies),
  energyAfter: energy(bodies),
  ...rest,
});

/** The oblique impact of two spheres, or of a sphere and a fixed plane if `body2` is left out. */
export const rebound = given => {
  const impact = read(given);
  const { bodies: [one, two], normal, friction } = impact;
  const relative = add(atContact(two, normal), atContact(one, normal), -1);
  const approach = dot(relative, normal);
  if (!(approach > 0)) {
    return answer(impact, impact.bodies, { meets: false, impulse: [0, 0, 0], rx: null, slides: false, groups: null });
  }
  const along = add(relative, normal, -approach);
  const slip = norm(along);
  const turning = body => body.inverseMass * (1 + 1 / body.inertia);
  const mobilities = [one.inverseMass + two.inverseMass, turning(one) + turning(two)];
  const groups = groupsOf(impact, mobilities, approach, slip);
  const rx = ofGroups(groups.chi, groups.psi, impact.restitution);

  const slides = groups.psi >= border(groups.chi, impact.restitution);
  const press = (1 + impact.restitution) * approach / mobilities[0];
  const limit = friction * press;
  const drag = slides ? limit : Math.min((1 + rx) * slip / mobilities[1], limit);
  const push = slip > 0 ? times(along, drag / slip) : REST;
  const impulse = add(push, normal, press);
  const after = [pushed(one, normal, impulse), pushed(two, normal, times(impulse, -1))];
  return answer(impact, after, { meets: true, impulse, rx, slides, groups });
};
