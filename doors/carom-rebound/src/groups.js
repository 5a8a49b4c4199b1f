// The numbers on which R_x depends.

import { number } from './check.js';
import { CHI, restitution } from './table.js';

/** The inertia factor of a solid sphere: moment of inertia over mass times radius squared. */
export const SOLID = 0.4;
/** The inertia factor of a thin spherical shell. */
export const HOLLOW = 2 / 3;
const LEAST_INERTIA = 0.35;
const KAPPA_END = 1.5 * (1 + 4 * Number.EPSILON); // computed from Poisson's ratio it may exceed 3/2 by round-off

export const inertiaFactor = (field, value) => number(
  field, value, given => given >= LEAST_INERTIA && given <= HOLLOW * (1 + 4 * Number.EPSILON),
  `from ${LEAST_INERTIA} to 2/3 (0.4 solid, 2/3 a thin shell)`,
);

/** kappa = c_z/c_x = (2 - nu)/(2 (1 - nu)): normal over tangential stiffness of like materials. */
export const kappaOf = poisson => {
  number('poisson', poisson, given => given > -1 && given <= 0.5, 'in (-1, 0.5]');
  return (2 - poisson) / (2 * (1 - poisson));
};

/** R_x of spheres with one inertia factor, by kappa and lambda = slip speed/(friction times approach speed). */
export const rx = (kappa, lambda, inertia = SOLID) => {
  number('kappa', kappa, given => given > 0.75 && given <= KAPPA_END, 'in (0.75, 1.5]');
  number('lambda', lambda, given => given >= 0, '>= 0');
  inertiaFactor('inertia', inertia);
  return restitution((1 + 1 / inertia) / kappa, lambda / kappa);
};

/** R_x of any bodies with uncoupled normal and tangential motion, by chi and psi. */
export const rxOfGroups = (chi, psi) => {
  number('chi', chi, given => given >= CHI[0] && given <= CHI[1], `from ${CHI[0]} to ${CHI[1]}`);
  number('psi', psi, given => given >= 0, '>= 0');
  return restitution(chi, psi);
};
