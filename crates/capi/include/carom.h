// carom: elastic impact with friction, for C and C++ (Fortran: see contact.f90).
//
// Made by cbindgen from the Rust sources of carom-capi; not to be edited.

#ifndef CAROM_H
#define CAROM_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

// Constants (carom_pair) are made once, memories (carom_contact, carom_touch) are the caller's, and
// every function returns a carom_status; what is wrong it writes into a carom_error, which may be
// null. All structures are plain data and may be copied as bytes. Nothing is kept between calls and
// no function needs another thread's permission: different data may be used by different threads.

// The law of an impact: the cheapest in which the coupling of dissimilar bodies counts. For spheres and planes it is
// CAROM_IMPACT_RINGS where coupling matters; for other shapes coupling is neglected, and CAROM_WARNING_COUPLING
// says so.
#define CAROM_IMPACT_AUTO 0

// `coulomb`, whichever the materials: coupling is neglected.
#define CAROM_IMPACT_COULOMB 1

// `fixed-direction`, whichever the materials: coupling is neglected.
#define CAROM_IMPACT_FIXED_DIRECTION 2

// `rings`, of spheres and planes: coupling and the spin about the normal count.
#define CAROM_IMPACT_RINGS 3

// With CAROM_IMPACT_AUTO friction acts on the spin about the normal where that matters; other laws leave it alone.
#define CAROM_TORSION_AUTO 0

// The spin is changed by a torsional impact of its own, as if there were no tangential impact.
#define CAROM_TORSION_INCLUDED 1

// The spin is left alone.
#define CAROM_TORSION_LEFT_OUT 2

// Nothing is lost in the bodies' material.
#define CAROM_LOSS_NONE 0

// `normal_restitution` of the elastic normal velocity is left, in [0, 1].
#define CAROM_LOSS_GIVEN 1

// What elastic waves carry away is lost, see CAROM_WARNING_WAVE_LOSS; `normal_restitution` says nothing.
#define CAROM_LOSS_BY_WAVES 2

// The words of 8 bytes in a `carom_contact`, beside its mark.
#define CAROM_CONTACT_WORDS 144

// A sphere: `sizes[0]` is its radius.
#define CAROM_SHAPE_SPHERE 0

// A plane with the half-space behind it, held fast; its axis c looks out of the body.
#define CAROM_SHAPE_PLANE 1

// An ellipsoid: `sizes` are its semi-axes.
#define CAROM_SHAPE_ELLIPSOID 2

// A cylinder about its axis c: radius and length.
#define CAROM_SHAPE_CYLINDER 3

// A cylinder between two half spheres, about its axis c: radius, and length of the straight part.
#define CAROM_SHAPE_CAPSULE 4

// A torus about its axis c: radius of the circle, radius of the tube.
#define CAROM_SHAPE_TORUS 5

// A box: `sizes` are its edges. Its edges and corners cannot touch.
#define CAROM_SHAPE_BOX 6

// The materials couple normal and tangential displacements, which the theory leaves out.
#define CAROM_WARNING_COUPLING 1

// The contact is not small against the bodies.
#define CAROM_WARNING_LARGE_CONTACT 2

// Elastic waves would carry away more than 1 % of the normal energy.
#define CAROM_WARNING_WAVE_LOSS 4

// The spin about the normal is left alone, and torsion would take more than 1 % of it.
#define CAROM_WARNING_SPIN_LEFT_ALONE 8

// The outcome did not settle to its tolerance.
#define CAROM_WARNING_NOT_SETTLED 16

// The contact point was found by sampling; the bodies may touch elsewhere too.
#define CAROM_WARNING_POINT_SAMPLED 32

// `coulomb`: each ring of the contact slips by itself, to a tolerance.
#define CAROM_LAW_COULOMB 0

// `fixed-direction`: one direction of traction in a slip ring (chapter 7 of the thesis). Exact on straight
// paths; where the direction turns, off by 5 % of the friction limit in the mean. Faster.
#define CAROM_LAW_FIXED_DIRECTION 1

// `rings`: approach, shift, twist and the coupling of dissimilar materials act together, on rings of the contact. For
// grains (`carom_ring_touch_grains`), whose contacts are circles. With 100 steps in an impact R_x is off by .01 at
// most, unless the tangential velocity is below f/2 times that of approach.
#define CAROM_LAW_RINGS 2

// R_x from the table: within 1e-8 of the exact impact, in tens of nanoseconds.
#define CAROM_BY_TABLE 0

// R_x by the exact impact, in microseconds.
#define CAROM_EXACT 1

// R_x of dissimilar spheres by rings, in milliseconds.
#define CAROM_BY_RINGS 2

// The words of 8 bytes in a `carom_ring_touch`, beside its mark.
#define CAROM_RING_TOUCH_WORDS 420

// The numbers in which a `carom_ring_touch` is kept elsewhere.
#define CAROM_RING_TOUCH_NUMBERS 309

// The first of these numbers, unless the grains are apart.
#define CAROM_RING_TOUCH_MARK 30001.0

// The numbers in a `carom_state`.
#define CAROM_STATE_NUMBERS 66

// The words of 8 bytes in a `carom_touch`, beside its mark.
#define CAROM_TOUCH_WORDS 158

// The numbers in which a `carom_touch` is kept elsewhere.
#define CAROM_TOUCH_NUMBERS 79

// The numbers in a `carom_twist`.
#define CAROM_TWIST_NUMBERS 83

// Changes whenever a structure or a function of this header does; compare it with
// `carom_abi_version()` of the library that is loaded.
#define CAROM_ABI_VERSION 5

// How a call ended.
enum carom_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // All is done.
  CAROM_STATUS_OK = 0,
  // A pointer that must not be null is.
  CAROM_STATUS_NULL_POINTER = 1,
  // A pointer or a stride is not aligned to what it points to.
  CAROM_STATUS_MISALIGNED = 2,
  // A value is out of range: `carom_error` names its field.
  CAROM_STATUS_OUT_OF_RANGE = 3,
  // A state is neither zero nor one that this library wrote.
  CAROM_STATUS_BAD_STATE = 4,
  // The bodies make no contact that can be computed.
  CAROM_STATUS_NO_CONTACT = 5,
  // The impact could not be followed to its end.
  CAROM_STATUS_NOT_FOLLOWED = 6,
  // A fault in this library; nothing can be said about the results.
  CAROM_STATUS_INTERNAL = 7,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_status carom_status;
#else
typedef int32_t carom_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// What the last step of a contact did.
enum carom_regime
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The bodies are apart.
  CAROM_REGIME_SEPARATED = 0,
  // Complete adhesion: the area grew faster than the shift.
  CAROM_REGIME_ADHESION = 1,
  // The edge receded, and what is left did not slip.
  CAROM_REGIME_RELEASE = 2,
  // A ring slipped.
  CAROM_REGIME_SLIP = 3,
  // Slip began anew at the edge, the other way.
  CAROM_REGIME_REVERSAL = 4,
  // A slip ring wiped out older ones.
  CAROM_REGIME_OVERLAY = 5,
  // The whole contact slid.
  CAROM_REGIME_SLIDING = 6,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_regime carom_regime;
#else
typedef uint32_t carom_regime;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The matrices of CAROM_LAW_RINGS for two materials with friction, some 60 kilobytes. They serve contacts of any
// radius, never change, and may be used by several threads at once.
typedef struct carom_rings carom_rings;

// The constants of a contact: plain data, made by `carom_pair_of_spheres` and its like and not to
// be changed but by them. Units are SI, or any consistent set.
typedef struct carom_pair {
  // Tangential stiffness along x: in full adhesion dF_x = c_x sqrt(zeta) dxi. N/m^1.5.
  double c_x;
  // The same along y.
  double c_y;
  // Normal stiffness: F_z = (2/3) c_z zeta^1.5. N/m^1.5.
  double c_z;
  // The coefficient of friction, from 0 to infinity (no slip).
  double friction;
  // How far the friction force may be off over its limit, of CAROM_LAW_COULOMB; how closely tractions keep their
  // limits, of CAROM_LAW_RINGS.
  double tolerance;
  // a^2/zeta of the contact ellipse, m; 0 if it is not known.
  double a_squared;
  // b^2/zeta of the contact ellipse, m; 0 if it is not known.
  double b_squared;
  // Torque over twist without slip, over zeta^1.5, N/m^0.5; 0 if it is not known.
  double torsion_stiffness;
  // The torque of sliding over friction times F_z, over zeta^0.5, m^0.5; 0 if it is not known.
  double torsion_arm;
  // The coupling of normal and tangential displacements (15.2); 0 for like bodies, or if it is not known.
  double gamma;
  // A bound of how much coupling changes R_x, the tangential velocity after an impact of spheres over that before.
  // The laws but CAROM_LAW_RINGS neglect it.
  double coupling_bound;
  // CAROM_LAW_COULOMB, CAROM_LAW_FIXED_DIRECTION or CAROM_LAW_RINGS.
  uint32_t law;
  // CAROM_ABI_VERSION of the library that made it.
  uint32_t version;
} carom_pair;

// The memory of a contact, the caller's: 1160 bytes, aligned to 8, that may be copied as bytes. Zero bytes
// are two bodies that just touch, unshifted. It is the law itself, constants and all, so that a
// step reads and writes only what it needs; it is understood only by the build that wrote it:
// `carom_contact_pack` makes a `carom_state` of it.
//
// The constants are those of the pair with which it was first advanced; to change them, make it zero.
typedef struct carom_contact {
  // Not to be changed but by the functions of this library.
  uint64_t mark;
  // The law.
  uint64_t words[CAROM_CONTACT_WORDS];
} carom_contact;

// The rigid shift of body 2 against body 1 in contact axes, z into body 1.
typedef struct carom_shift {
  // The approach, positive in contact, m.
  double zeta;
  // The shift along x, m.
  double xi;
  // The shift along y, m.
  double eta;
} carom_shift;

// The load that body 2 exerts on body 1.
typedef struct carom_load {
  // Tangential force along x, N.
  double f_x;
  // Tangential force along y, N.
  double f_y;
  // Normal force, positive in compression, N.
  double f_z;
} carom_load;

// What was wrong: filled in by a call that does not return `CAROM_STATUS_OK`, else left alone.
typedef struct carom_error {
  // The entry of an array, counted from 0; -1 where there is no array.
  int64_t index;
  // The value of the field; 0 where there is none.
  double value;
  // The name of the field or argument; empty where there is none. Ends with a zero.
  char field[40];
  // A sentence for a person. Ends with a zero.
  char text[200];
} carom_error;

// What a contact can tell beside its load.
typedef struct carom_report {
  // The share of the contact area that sticks.
  double sticking;
  // What the last step did.
  carom_regime regime;
} carom_report;

// What a contact remembers, in 66 numbers, the caller's: zeros are two bodies that just touch, unshifted.
// The numbers mean the same on any machine and in any build of this `carom_state_version()`, so
// that they can be kept in files and sent to other processes. `carom_contact_pack` writes them,
// `carom_contact_unpack` makes a contact of them, whose further way is the same to the bit. The friction of the
// pair must be finite.
typedef struct carom_state {
  // Not to be changed but by the functions of this library.
  double numbers[CAROM_STATE_NUMBERS];
} carom_state;

// The constants of the contacts of two materials: plain data, made by `carom_grains_of` and not to be
// changed but by it.
typedef struct carom_grains {
  // The contact of a relative radius of 1.
  struct carom_pair unit;
  // The viscous relaxation time of the materials, s.
  double relaxation;
  // The share of the approach by which body 1 gives way.
  double share_1;
  // The share of the approach by which body 2 gives way.
  double share_2;
} carom_grains;

// The memory of the contact of two grains, the caller's: 1280 bytes, aligned to 8, that may be copied as
// bytes. Zero bytes are two grains apart. It is understood only by the build that wrote it:
// `carom_touch_pack` makes numbers of it that any build of this `carom_state_version()` understands.
//
// The constants are those of the step in which it began; to change them, make it zero.
typedef struct carom_touch {
  // Not to be changed but by the functions of this library.
  uint64_t mark;
  // The contact.
  uint64_t words[CAROM_TOUCH_WORDS];
} carom_touch;

// A sphere with its motion, as a particle code stores it.
typedef struct carom_grain {
  // Position of its centre, m.
  double place[3];
  // The velocity of its centre, m/s.
  double velocity[3];
  // Angular velocity, rad/s.
  double spin[3];
  // Its radius, m.
  double radius;
} carom_grain;

// What body 2 exerts on body 1.
typedef struct carom_grain_load {
  // The force on body 1, N; that on body 2 is the opposite one.
  double force[3];
  // The torque on body 1 about its centre, N m.
  double torque_1[3];
  // The torque on body 2 about its centre, N m; that on a wall is zero.
  double torque_2[3];
} carom_grain_load;

// Two grains and their contact, of many that make their step in one call.
typedef struct carom_encounter {
  // The constants of their materials.
  const struct carom_grains *grains;
  // Their contact: of each pair its own.
  struct carom_touch *touch;
  // Body 1.
  struct carom_grain one;
  // Body 2.
  struct carom_grain two;
  // What body 2 exerts on body 1 at the end of the step: to be written.
  struct carom_grain_load load;
} carom_encounter;

// Dissipated energy, by cause, J.
typedef struct carom_heats {
  // Friction heat, including the energy released at a receding edge.
  double friction;
  // Energy dissipated by the viscoelastic material.
  double damping;
} carom_heats;

// An elastic material, or a rigid one.
typedef struct carom_material {
  // Young's modulus, Pa; infinite for a rigid body.
  double young_modulus;
  // Poisson's ratio, in (-1, 0.5]; of no meaning for a rigid body.
  double poisson;
} carom_material;

// A flat wall, which may move.
typedef struct carom_wall {
  // Position of any of its points, m.
  double place[3];
  // Unit normal, pointing towards the grains.
  double normal[3];
  // Its velocity, m/s.
  double velocity[3];
} carom_wall;

// A body about to collide. All that is zero is what is usual: a solid, its axes along those of space,
// at the origin, at rest.
typedef struct carom_body {
  // A CAROM_SHAPE.
  uint32_t shape;
  // 1 for a thin shell, 0 for a solid.
  uint32_t hollow;
  // What the shape needs, m.
  double sizes[3];
  // The mass, kg; infinite if it is held fast. Of no meaning for a plane.
  double mass;
  // The principal moments of inertia, kg m^2; zeros are those of the homogeneous shape.
  double moments[3];
  // The material.
  struct carom_material material;
  // The centre of mass; for a plane any of its points, m.
  double centre[3];
  // The unit quaternion (w, i, j, k) that turns the body's components into those of space; zeros for
  // none.
  double attitude[4];
  // The velocity of the centre of mass, m/s.
  double velocity[3];
  // The angular velocity in space axes, rad/s.
  double spin[3];
} carom_body;

// How an impact is computed. Zeros are what is usual in all but `size`.
typedef struct carom_collide_options {
  // `sizeof(carom_collide_options)`: later versions add fields at the end, which are zero for a caller of this one.
  size_t size;
  // A CAROM_IMPACT.
  uint32_t law;
  // A CAROM_LOSS: what the bodies' material takes, beyond the elastic theory. Impulse and heat of friction shrink with
  // the normal pulse; duration, force and approach are those of the elastic impact.
  uint32_t loss;
  // The part of the elastic normal velocity that CAROM_LOSS_GIVEN leaves: 1 is elastic, at 0 the bodies do not part.
  double normal_restitution;
  // To which the outcome is settled; 0 for the usual one.
  double tolerance;
  // A CAROM_TORSION: what becomes of the spin about the normal where the law is not CAROM_IMPACT_RINGS.
  uint32_t torsion;
} carom_collide_options;

// How two bodies part. Velocities of the contact are of body 2 against body 1. The command's columns and
// Python's record have the same names.
typedef struct carom_rebound {
  // 1 if they collide; 0 if they do not approach each other, where nothing happens and only
  // place, normal and motions are given.
  uint32_t collides;
  // The CAROM_WARNING bits that hold.
  uint32_t warnings;
  // The velocity of the centre of mass of body 1 afterwards, m/s.
  double body_1_velocity[3];
  // The angular velocity of body 1 afterwards, rad/s.
  double body_1_spin[3];
  // The velocity of the centre of mass of body 2 afterwards, m/s.
  double body_2_velocity[3];
  // The angular velocity of body 2 afterwards, rad/s.
  double body_2_spin[3];
  // The impulse that body 2 gave body 1, N s.
  double impulse[3];
  // The place where they touch, m.
  double point[3];
  // The normal there, from body 2 into body 1.
  double normal[3];
  // The relative velocity of the contact points before, m/s.
  double contact_velocity_before[3];
  // The relative velocity of the contact points after, m/s.
  double contact_velocity_after[3];
  // The tangential velocity after over that before, reversed in sign, if `has_R_x`.
  double R_x;
  // 1 if there is an R_x.
  uint32_t has_R_x;
  // How often the approach grew.
  uint32_t compressions;
  // The time from touch to separation, s.
  double duration;
  // The greatest normal force, N.
  double maximal_force;
  // The greatest approach, m.
  double maximal_approach;
  // The semi-axis of the greatest contact ellipse along the contact's x, the smaller one, m.
  double maximal_semi_axis_a;
  // The semi-axis of the greatest contact ellipse along the contact's y, m.
  double maximal_semi_axis_b;
  // The kinetic energy before, J.
  double energy_before;
  // The kinetic energy after, J.
  double energy_after;
  // What friction took, J.
  double energy_dissipated;
  // What the bodies' material took, J: 0 of elastic ones.
  double energy_lost;
  // How far the velocity after may be off over that before; 0 where the solution is exact.
  double error_estimate;
  // The relative spin about the normal after over that before, if `has_torsion`.
  double spin_ratio;
  // The impulse of the torque on body 1 about the normal, N m s, if `has_torsion`.
  double torque_impulse;
  // 1 if the spin about the normal was changed.
  uint32_t has_torsion;
} carom_rebound;

// The memory of the contact of two grains with CAROM_LAW_RINGS, the caller's: 3368 bytes, aligned to 8, that may be
// copied as bytes. Zero bytes are two grains apart. It is understood only by the build that wrote it:
// `carom_ring_touch_pack` makes numbers of it that any build of this `carom_state_version()` understands.
//
// Shift, twist and the coupling of dissimilar materials act together: no `carom_twist` stands beside it.
typedef struct carom_ring_touch {
  // Not to be changed but by the functions of this library.
  uint64_t mark;
  // The contact.
  uint64_t words[CAROM_RING_TOUCH_WORDS];
} carom_ring_touch;

// The memory of a contact that twists about its normal, in 83 numbers, the caller's: zeros are two bodies
// that just touch, untwisted. It stands beside the memory of the shift, each as if the other were absent.
// As a `carom_state` the numbers may be kept in files and sent to other processes.
//
// 12 pieces of the history, one or two for a turn of the twist, are remembered to the bit; beyond, those
// that matter least are joined: over random histories the torque was then off by less than 3e-4 of that
// of sliding in the mean, .02 at worst.
typedef struct carom_twist {
  // Not to be changed but by the functions of this library.
  double numbers[CAROM_TWIST_NUMBERS];
} carom_twist;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Advances many contacts of one pair, contact i by its own shift. The strides are the bytes from one
// entry to the next, so that the arrays may be columns of larger structures; `loads` may be null.
//
// All shifts are checked before anything moves: if one is out of range nothing is changed, and
// `error->index` names it. A contact that is none ends the call at its index: those before it have
// been advanced.
//
// # Safety
// `pair` is null or may be read. `contacts`, `shifts` and `loads` are null, or each of their `count`
// entries may be read and, but for the shifts, written; none overlaps another. Each contact is as in
// `carom_contact_advance`. `error` is null or may be written.
carom_status carom_contact_advance_many(const struct carom_pair *pair,
                                        size_t count,
                                        struct carom_contact *contacts,
                                        size_t contact_stride,
                                        const struct carom_shift *shifts,
                                        size_t shift_stride,
                                        struct carom_load *loads,
                                        size_t load_stride,
                                        struct carom_error *error);

// Goes straight from the present shift to a new one; `load` may be null.
//
// A `zeta` that is not positive separates the bodies: the memory is lost.
//
// # Safety
// `pair` is null or may be read; `contact`, `load` and `error` are null or may be written. The
// contact is zero, or was written by this build of the library; other bytes end in a status, or in
// numbers that mean nothing.
carom_status carom_contact_advance(const struct carom_pair *pair,
                                   struct carom_contact *contact,
                                   struct carom_shift shift,
                                   struct carom_load *load,
                                   struct carom_error *error);

// The present load.
//
// # Safety
// `pair` and `contact` are null or may be read; `load` and `error` are null or may be written. The
// contact is as in `carom_contact_advance`.
carom_status carom_contact_load(const struct carom_pair *pair,
                                const struct carom_contact *contact,
                                struct carom_load *load,
                                struct carom_error *error);

// The elastic energy of the contact, compression included, J.
//
// # Safety
// As `carom_contact_load`.
carom_status carom_contact_energy(const struct carom_pair *pair,
                                  const struct carom_contact *contact,
                                  double *energy,
                                  struct carom_error *error);

// The energy that the straight step to `shift` would turn into heat, or release at a receding edge,
// J. Nothing moves.
//
// # Safety
// As `carom_contact_load`.
carom_status carom_contact_heat(const struct carom_pair *pair,
                                const struct carom_contact *contact,
                                struct carom_shift shift,
                                double *heat,
                                struct carom_error *error);

// What the last step did, and how much of the contact sticks.
//
// # Safety
// As `carom_contact_load`.
carom_status carom_contact_report(const struct carom_pair *pair,
                                  const struct carom_contact *contact,
                                  struct carom_report *report,
                                  struct carom_error *error);

// Turns the contact axes by an angle (radians, from x to y): what is remembered is expressed in the
// new ones, and stays the same in space.
//
// # Safety
// `pair` is null or may be read; `contact` and `error` are null or may be written. The contact is
// as in `carom_contact_advance`.
carom_status carom_contact_turn_frame(const struct carom_pair *pair,
                                      struct carom_contact *contact,
                                      double angle,
                                      struct carom_error *error);

// Writes what a contact remembers into a state, for a file or another process.
//
// # Safety
// `pair` and `contact` are null or may be read; `state` and `error` are null or may be written. The
// contact is as in `carom_contact_advance`.
carom_status carom_contact_pack(const struct carom_pair *pair,
                                const struct carom_contact *contact,
                                struct carom_state *state,
                                struct carom_error *error);

// Makes a contact of what a state remembers. A contact that is not zero keeps its constants, which is
// faster: one contact may take up many states of a pair, one after the other.
//
// # Safety
// `pair` and `state` are null or may be read; `contact` and `error` are null or may be written.
carom_status carom_contact_unpack(const struct carom_pair *pair,
                                  const struct carom_state *state,
                                  struct carom_contact *contact,
                                  struct carom_error *error);

// One step of the duration `dt` of many pairs of grains: `carom_touch_grains` for each, to the same bits and
// in less time, since some go through the processor together.
//
// What cannot make its step ends the call, and `error->index` names it: those before it have made theirs.
// `heats` may be null; it costs several times the force.
//
// # Safety
// `encounters` is null or `count` of them may be read and written, and what each points to is as in
// `carom_touch_grains`; no two have the same touch. `heats` and `error` are null or may be written.
carom_status carom_touch_many(struct carom_encounter *encounters,
                              size_t count,
                              double dt,
                              struct carom_heats *heats,
                              struct carom_error *error);

// A few words for each status; never null, and not to be freed.
const char *carom_status_text(int32_t status);

// The constants of the contacts of grains of two materials, of any radii, or of grains of material 1 and
// a wall of material 2.
//
// `relaxation` is the viscous relaxation time A of the pair, s, which adds
// (2/3) c_z (3/2) A sqrt(zeta) dzeta/dt to Hertz's force; 0 for none. `law` and `tolerance` are as in
// `carom_pair_of_spheres`; friction is finite.
//
// # Safety
// The materials are null or may be read, `grains` and `error` null or may be written.
carom_status carom_grains_of(const struct carom_material *material_1,
                             const struct carom_material *material_2,
                             double friction,
                             uint32_t law,
                             double tolerance,
                             double relaxation,
                             struct carom_grains *grains,
                             struct carom_error *error);

// One step of the duration `dt` of the contact of two grains, at whose end they are as told; the
// velocities are those that brought them there (of a leapfrog: those between). `heats` may be null; it
// costs several times the force.
//
// Where the two come apart the memory is lost; a step of accounted heat sees what is released then. A
// touch need not be told of grains that are apart and stay so.
//
// # Safety
// `grains`, `one` and `two` are null or may be read; `touch`, `load`, `heats` and `error` are null or may
// be written. The touch is zero, or was written by this build of the library; other bytes end in a status, or
// in numbers that mean nothing.
carom_status carom_touch_grains(const struct carom_grains *grains,
                                struct carom_touch *touch,
                                const struct carom_grain *one,
                                const struct carom_grain *two,
                                double dt,
                                struct carom_grain_load *load,
                                struct carom_heats *heats,
                                struct carom_error *error);

// The same of a grain, body 1, and a wall.
//
// # Safety
// As `carom_touch_grains`.
carom_status carom_touch_wall(const struct carom_grains *grains,
                              struct carom_touch *touch,
                              const struct carom_grain *one,
                              const struct carom_wall *wall,
                              double dt,
                              struct carom_grain_load *load,
                              struct carom_heats *heats,
                              struct carom_error *error);

// The load of two grains as the last step left them, without a step: the same bits that it told, if the
// places are the same. A touch that is zero carries Hertz's force alone.
//
// # Safety
// `grains`, `touch`, `one` and `two` are null or may be read; `load` and `error` are null or may be
// written. The touch is as in `carom_touch_grains`.
carom_status carom_touch_grains_load(const struct carom_grains *grains,
                                     const struct carom_touch *touch,
                                     const struct carom_grain *one,
                                     const struct carom_grain *two,
                                     struct carom_grain_load *load,
                                     struct carom_error *error);

// The same of a grain, body 1, and a wall.
//
// # Safety
// As `carom_touch_grains_load`.
carom_status carom_touch_wall_load(const struct carom_grains *grains,
                                   const struct carom_touch *touch,
                                   const struct carom_grain *one,
                                   const struct carom_wall *wall,
                                   struct carom_grain_load *load,
                                   struct carom_error *error);

// The impact of two bodies that touch where they are, or, if `normal` is not null, of body 1 put on body
// 2 with that common normal, from body 2 into body 1.
//
// `options` is null for what is usual: elastic bodies, and the coupling of normal and tangential displacements of
// dissimilar ones counts for spheres and planes, with it the spin about the normal.
//
// # Safety
// `body_1`, `body_2` and the three numbers of `normal` are null or may be read; `options` is null, or as many bytes
// as its `size` says may be read; `rebound` and `error` are null or may be written.
carom_status carom_collide(const struct carom_body *body_1,
                           const struct carom_body *body_2,
                           double friction,
                           const double *normal,
                           const struct carom_collide_options *options,
                           struct carom_rebound *rebound,
                           struct carom_error *error);

// The constants of two spheres, or of a sphere on a plane (an infinite radius) or in a hollow sphere
// (a negative radius). A tolerance of 0 is that of particles: 1e-2, of CAROM_LAW_RINGS
// 3e-3.
//
// # Safety
// The materials are null or may be read, `pair` and `error` null or may be written.
carom_status carom_pair_of_spheres(const struct carom_material *material_1,
                                   const struct carom_material *material_2,
                                   double radius_1,
                                   double radius_2,
                                   double friction,
                                   uint32_t law,
                                   double tolerance,
                                   struct carom_pair *pair,
                                   struct carom_error *error);

// The constants of two bodies whose gap is A x^2 + B y^2 (1/m).
//
// # Safety
// As `carom_pair_of_spheres`.
carom_status carom_pair_of_curvatures(const struct carom_material *material_1,
                                      const struct carom_material *material_2,
                                      double curvature_a,
                                      double curvature_b,
                                      double friction,
                                      uint32_t law,
                                      double tolerance,
                                      struct carom_pair *pair,
                                      struct carom_error *error);

// The constants of a contact of known stiffness, dF_x = c_x sqrt(zeta) dxi and so on.
//
// # Safety
// `pair` and `error` are null or may be written.
carom_status carom_pair_of_stiffness(double c_x,
                                     double c_y,
                                     double c_z,
                                     double friction,
                                     uint32_t law,
                                     double tolerance,
                                     struct carom_pair *pair,
                                     struct carom_error *error);

// R_x, the tangential velocity after an impact of solid spheres over that before, reversed in sign.
//
// `kappa` = (2 - nu)/(2 (1 - nu)) is that of the materials, in (0.75, 1.5]; `lambda` >= 0 the
// tangential velocity of the contact over f times the normal one. `method` is CAROM_BY_TABLE or
// CAROM_EXACT.
//
// # Safety
// `restitution` and `error` are null or may be written.
carom_status carom_restitution(double kappa,
                               double lambda,
                               uint32_t method,
                               double *restitution,
                               struct carom_error *error);

// R_x of many pairs of `kappa` and `lambda`. The strides are the bytes from one entry to the next; 0
// takes the same entry again and again. The first pair without an answer ends the call:
// `error->index` names it, and those before it have been written.
//
// # Safety
// `kappa`, `lambda` and `restitution` are null, or each of their `count` entries may be read, those of
// `restitution` written; these overlap nothing. `error` is null or may be written.
carom_status carom_restitution_many(size_t count,
                                    const double *kappa,
                                    size_t kappa_stride,
                                    const double *lambda,
                                    size_t lambda_stride,
                                    uint32_t method,
                                    double *restitution,
                                    size_t restitution_stride,
                                    struct carom_error *error);

// R_x of spheres or planes of dissimilar materials without spin about the normal.
//
// `gamma`, of either sign, is the coupling (15.2) of the materials, at most 3/2 - `kappa`, which is in
// [0.75, 1.5]. `friction` is f, from 0 to infinity; `lambda` >= 0 as for `carom_restitution`, 0 where f is
// infinite. `mobility_ratio`, in (0, 75], is D_xx/D_zz: 3.5 of solid spheres, 2.5 of hollow ones.
//
// `method` tells how it was found, and `error_estimate` how far it may be off; each may be null:
// - CAROM_EXACT: gamma = 0, with the bits of `carom_restitution`, or no friction.
// - CAROM_BY_TABLE: in half a microsecond, for kappa from 1, lambda to 8, f to 1, |gamma|/f to 12 and
//   mobility_ratio from 1 to 6.
// - CAROM_BY_RINGS: elsewhere.
//
// # Safety
// `restitution` may be written; `error_estimate`, `method` and `error` are null or may be written.
carom_status carom_restitution_dissimilar(double kappa,
                                          double gamma,
                                          double friction,
                                          double lambda,
                                          double mobility_ratio,
                                          double *restitution,
                                          double *error_estimate,
                                          uint32_t *method,
                                          struct carom_error *error);

// One step of the contact of two grains with CAROM_LAW_RINGS, as `carom_touch_grains`; the torques contain that
// about the normal. `rings` are those of `grains->unit`. `heats` may be null; it costs nothing here.
//
// A step costs 2 to 5 microseconds.
//
// # Safety
// `grains`, `one` and `two` are null or may be read; `rings` is null or was made by `carom_rings_of`; `touch`, `load`,
// `heats` and `error` are null or may be written. The touch is zero, or was written by this build of the library;
// other bytes end in a status, or in numbers that mean nothing.
carom_status carom_ring_touch_grains(const struct carom_grains *grains,
                                     const struct carom_rings *rings,
                                     struct carom_ring_touch *touch,
                                     const struct carom_grain *one,
                                     const struct carom_grain *two,
                                     double dt,
                                     struct carom_grain_load *load,
                                     struct carom_heats *heats,
                                     struct carom_error *error);

// The same of a grain, body 1, and a wall, which takes no torque.
//
// # Safety
// As `carom_ring_touch_grains`.
carom_status carom_ring_touch_wall(const struct carom_grains *grains,
                                   const struct carom_rings *rings,
                                   struct carom_ring_touch *touch,
                                   const struct carom_grain *one,
                                   const struct carom_wall *wall,
                                   double dt,
                                   struct carom_grain_load *load,
                                   struct carom_heats *heats,
                                   struct carom_error *error);

// The load of two grains as the last step left them, without a step, as `carom_touch_grains_load`.
//
// # Safety
// `grains`, `touch`, `one` and `two` are null or may be read; `load` and `error` are null or may be
// written. Rings and touch are as in `carom_ring_touch_grains`.
carom_status carom_ring_touch_grains_load(const struct carom_grains *grains,
                                          const struct carom_rings *rings,
                                          const struct carom_ring_touch *touch,
                                          const struct carom_grain *one,
                                          const struct carom_grain *two,
                                          struct carom_grain_load *load,
                                          struct carom_error *error);

// The same of a grain, body 1, and a wall.
//
// # Safety
// As `carom_ring_touch_grains_load`.
carom_status carom_ring_touch_wall_load(const struct carom_grains *grains,
                                        const struct carom_rings *rings,
                                        const struct carom_ring_touch *touch,
                                        const struct carom_grain *one,
                                        const struct carom_wall *wall,
                                        struct carom_grain_load *load,
                                        struct carom_error *error);

// The elastic energy of a contact, compression and twist included, J; the radius of a wall is infinite.
//
// # Safety
// As `carom_ring_touch_grains_load`.
carom_status carom_ring_touch_energy(const struct carom_grains *grains,
                                     const struct carom_rings *rings,
                                     const struct carom_ring_touch *touch,
                                     double radius_1,
                                     double radius_2,
                                     double *energy,
                                     struct carom_error *error);

// The share of the contact that sticks, and what the last step did: separated, adhesion, slip or sliding.
//
// # Safety
// `touch` is null or may be read; `rings` is as in `carom_ring_touch_grains`; `report` and `error` are null or may be
// written.
carom_status carom_ring_touch_report(const struct carom_rings *rings,
                                     const struct carom_ring_touch *touch,
                                     struct carom_report *report,
                                     struct carom_error *error);

// Writes a contact into CAROM_RING_TOUCH_NUMBERS numbers, for a file or another process: zeros are two grains
// apart, the first of others is positive.
//
// # Safety
// `touch` is null or may be read; `numbers` is null or has room for so many; `error` is null or may be
// written. The touch is as in `carom_ring_touch_grains`.
carom_status carom_ring_touch_pack(const struct carom_ring_touch *touch,
                                   double *numbers,
                                   struct carom_error *error);

// Makes a contact of what `carom_ring_touch_pack` wrote, of the same constants and radii; that of a wall is
// infinite. Its load is the same to the bit, and so is the way on from there.
//
// # Safety
// `grains` is null or may be read, `numbers` null or may be read so far; `touch` and `error` are null or
// may be written; `rings` is as in `carom_ring_touch_grains`.
carom_status carom_ring_touch_unpack(const struct carom_grains *grains,
                                     const struct carom_rings *rings,
                                     double radius_1,
                                     double radius_2,
                                     const double *numbers,
                                     struct carom_ring_touch *touch,
                                     struct carom_error *error);

// Makes the matrices of a pair of CAROM_LAW_RINGS, in a fraction of a millisecond (the first takes 10 ms);
// `carom_rings_free` gives them back. Those of `grains->unit` serve all contacts of the two materials.
//
// # Safety
// `pair` is null or may be read; `rings` and `error` are null or may be written.
carom_status carom_rings_of(const struct carom_pair *pair,
                            struct carom_rings **rings,
                            struct carom_error *error);

// Gives back what `carom_rings_of` made; null is allowed.
//
// # Safety
// `rings` is null, or was made by `carom_rings_of` and is not used again.
void carom_rings_free(struct carom_rings *rings);

// The elastic energy of a contact, compression included, J.
//
// # Safety
// `touch` is null or may be read; `energy` and `error` are null or may be written. The touch is as in
// `carom_touch_grains`.
carom_status carom_touch_energy(const struct carom_touch *touch,
                                double *energy,
                                struct carom_error *error);

// What the last step did, and how much of the contact sticks.
//
// # Safety
// As `carom_touch_energy`.
carom_status carom_touch_report(const struct carom_touch *touch,
                                struct carom_report *report,
                                struct carom_error *error);

// Writes a contact into CAROM_TOUCH_NUMBERS numbers, for a file or another process: zeros are two grains
// apart, the first of others is positive.
//
// # Safety
// `touch` is null or may be read; `numbers` is null or has room for so many; `error` is null or may be
// written. The touch is as in `carom_touch_grains`.
carom_status carom_touch_pack(const struct carom_touch *touch,
                              double *numbers,
                              struct carom_error *error);

// Makes a contact of what `carom_touch_pack` wrote, of the same constants and radii; that of a wall is
// infinite. Its load is the same to the bit, and so is the way on from there.
//
// # Safety
// `grains` is null or may be read, `numbers` null or may be read so far; `touch` and `error` are null or
// may be written.
carom_status carom_touch_unpack(const struct carom_grains *grains,
                                double radius_1,
                                double radius_2,
                                const double *numbers,
                                struct carom_touch *touch,
                                struct carom_error *error);

// One step of the twist of two grains about their normal, beside that of `carom_touch_grains` and as if the
// contact were not shifted; its torque is added to those of `load`, its heat to `heats`, which may be null.
//
// The twist is zero for two grains apart. A step of no duration only tells the torque that the last step
// left, but for a new contact. Where the two come apart the memory is lost. It costs tens of times a
// touch.
//
// # Safety
// `grains`, `one` and `two` are null or may be read; `twist`, `load`, `heats` and `error` are null or may
// be written.
carom_status carom_touch_twist_grains(const struct carom_grains *grains,
                                      struct carom_twist *twist,
                                      const struct carom_grain *one,
                                      const struct carom_grain *two,
                                      double dt,
                                      struct carom_grain_load *load,
                                      struct carom_heats *heats,
                                      struct carom_error *error);

// The same of a grain, body 1, and a wall, which takes no torque.
//
// # Safety
// As `carom_touch_twist_grains`.
carom_status carom_touch_twist_wall(const struct carom_grains *grains,
                                    struct carom_twist *twist,
                                    const struct carom_grain *one,
                                    const struct carom_wall *wall,
                                    double dt,
                                    struct carom_grain_load *load,
                                    struct carom_heats *heats,
                                    struct carom_error *error);

// The elastic energy of the twist of two grains, J; the radius of a wall is infinite.
//
// # Safety
// `grains` and `twist` are null or may be read, `energy` and `error` null or may be written.
carom_status carom_touch_twist_energy(const struct carom_grains *grains,
                                      const struct carom_twist *twist,
                                      double radius_1,
                                      double radius_2,
                                      double *energy,
                                      struct carom_error *error);

// Goes straight to a new approach (m) and twist of body 2 against body 1 about the normal (radians);
// `torque`, that on body 1 in N m, may be null.
//
// A `zeta` that is not positive separates the bodies: the memory is lost.
//
// # Safety
// `pair` is null or may be read; `twist`, `torque` and `error` are null or may be written.
carom_status carom_twist_advance(const struct carom_pair *pair,
                                 struct carom_twist *twist,
                                 double zeta,
                                 double omega,
                                 double *torque,
                                 struct carom_error *error);

// The present torque on body 1, N m.
//
// # Safety
// `pair` and `twist` are null or may be read; `torque` and `error` are null or may be written.
carom_status carom_twist_torque(const struct carom_pair *pair,
                                const struct carom_twist *twist,
                                double *torque,
                                struct carom_error *error);

// The elastic energy of the twist alone, J.
//
// # Safety
// As `carom_twist_torque`.
carom_status carom_twist_energy(const struct carom_pair *pair,
                                const struct carom_twist *twist,
                                double *energy,
                                struct carom_error *error);

// The energy that the straight step to an approach and a twist would turn into heat, J. Nothing moves.
//
// # Safety
// As `carom_twist_torque`.
carom_status carom_twist_heat(const struct carom_pair *pair,
                              const struct carom_twist *twist,
                              double zeta,
                              double omega,
                              double *heat,
                              struct carom_error *error);

// The version of the library, as "0.1.0"; not to be freed.
const char *carom_version(void);

// The version of the structures and functions of this library.
uint32_t carom_abi_version(void);

// The version of the numbers in a `carom_state`: a file of another version cannot be read.
uint32_t carom_state_version(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CAROM_H */
