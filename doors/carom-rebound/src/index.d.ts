/** x, y and z. */
export type Vector = readonly [number, number, number] | Float64Array | Float32Array;
/** x, y and z of an answer. */
export type Vector3 = [number, number, number];

/** A sphere before the impact. Any consistent units; SI in the examples. */
export interface Sphere {
  /** > 0. */
  mass: number;
  /** > 0. */
  radius: number;
  /** Moment of inertia over mass times radius squared, from 0.35 to 2/3; 0.4 (solid) if left out. */
  inertia?: number;
  /** Velocity of the centre; at rest if left out. */
  velocity?: Vector;
  /** Angular velocity; none if left out. */
  spin?: Vector;
}

/** An oblique impact of bodies of like materials with Coulomb friction. */
export interface Impact {
  body1: Sphere;
  /** A fixed plane at rest if left out. */
  body2?: Sphere;
  /** The common normal, from body 2 into body 1, of any length > 0; [0, 0, 1] if left out. */
  normal?: Vector;
  /** Poisson's ratio of both bodies, in (-1, 0.5]. */
  poisson: number;
  /** Coefficient of friction, >= 0. */
  friction: number;
  /** Normal velocity after over before, from 0 to 1; 1 (elastic) if left out. */
  restitution?: number;
}

/** The numbers on which R_x depends. */
export interface Groups {
  /** Normal over tangential stiffness, c_z/c_x = (2 - nu)/(2 (1 - nu)). */
  kappa: number;
  /** Slip speed of the contact over friction times approach speed. */
  lambda: number;
  /** Tangential over normal mobility, over kappa; 7/(2 kappa) for solid spheres. */
  chi: number;
  /** lambda/kappa. */
  psi: number;
}

/** The bodies after the impact. Of a plane the velocity and the spin are 0. */
export interface Rebound {
  /** False if the bodies do not approach each other; they then go on as before. */
  meets: boolean;
  /** Velocities of the centres of body 1 and body 2. */
  velocities: [Vector3, Vector3];
  /** Angular velocities of body 1 and body 2. */
  spins: [Vector3, Vector3];
  /** The impulse on body 1; body 2 has the opposite one. */
  impulse: Vector3;
  /** R_x, slip velocity of the contact after over before, reversed; null if the bodies do not meet. */
  rx: number | null;
  /** Whether the contact slides from first touch to separation. */
  slides: boolean;
  /** Null if the bodies do not meet. */
  groups: Groups | null;
  /** Kinetic energy of both bodies. */
  energyBefore: number;
  /** Kinetic energy of both bodies; never above `energyBefore`, round-off apart. */
  energyAfter: number;
}

/** A value that is not of the kind asked for, or out of its range. */
export class InputError extends RangeError {
  /** Where it stands, as `body1.velocity[2]`. */
  readonly field: string;
  readonly value: unknown;
  /** What is allowed, in words. */
  readonly allowed: string;
}

/** Inertia factor of a solid sphere, 0.4. */
export const SOLID: number;
/** Inertia factor of a thin spherical shell, 2/3. */
export const HOLLOW: number;

/**
 * The oblique impact of two spheres, or of a sphere and a fixed plane.
 * @throws InputError for input out of range.
 */
export function rebound(impact: Impact): Rebound;

/**
 * R_x of spheres with one inertia factor: of two, or of one and a plane.
 * @param kappa in (0.75, 1.5], see {@link kappaOf}.
 * @param lambda slip speed of the contact over friction times approach speed, >= 0.
 * @param inertia from 0.35 to 2/3; 0.4 (solid) if left out.
 * @throws InputError for input out of range.
 */
export function rx(kappa: number, lambda: number, inertia?: number): number;

/**
 * R_x of any bodies whose normal and tangential motions are uncoupled.
 * @param chi tangential over normal mobility times stiffness, from 1 to 5.25.
 * @param psi lambda/kappa, >= 0.
 * @throws InputError for input out of range.
 */
export function rxOfGroups(chi: number, psi: number): number;

/**
 * kappa of like materials, (2 - nu)/(2 (1 - nu)).
 * @throws InputError unless Poisson's ratio is in (-1, 0.5].
 */
export function kappaOf(poisson: number): number;
