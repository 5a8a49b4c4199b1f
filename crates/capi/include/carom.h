/* carom: elastic impact with friction, for C and C++ (Fortran: see contact.f90).
 *
 * Made from the Rust sources of carom-capi; not to be edited.
 *
 * Calls. Every function that can fail returns a carom_status. What is wrong it writes as a sentence into the
 * `text` of a carom_error, which may always be null. A failed call leaves the data of the caller as they
 * were; a call on many contacts keeps those before the one that failed. The library keeps nothing between
 * calls, so that different threads may work on different data.
 *
 * Data. Structures are plain data that may be copied as bytes. A carom_law is made once and freed at the end; it is the
 * only memory that the library allocates. Memories (carom_touch, carom_contact) belong to the caller: zero bytes at
 * first, afterwards written by this build of the library only. Other bytes give an error status or meaningless numbers.
 * The size of a touch is told by its law. Units are SI, or any consistent set.
 *
 * Pointers. A pointer must be null or point to an object of its type; where the function names a number of
 * entries, to the first of so many. The objects that a call writes must overlap no other. A null pointer
 * where none is allowed gives CAROM_STATUS_NULL_POINTER, one that is not aligned CAROM_STATUS_MISALIGNED.
 *
 * Contents
 *
 *   1. Errors and versions
 *   2. Materials and the names of laws
 *   3. Contacts of particles: grains and walls
 *   4. Surfaces of triangles
 *   5. Contacts with given shifts
 *   6. Impacts
 *   7. R_x of spheres
 *   8. Creep forces of a rolling contact
 *   9. Limits of the theory */

#ifndef CAROM_H
#define CAROM_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- 1. Errors and versions --------------------------------------------------- */

/* Result of a call. */
enum carom_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif /* defined(__cplusplus) || __STDC_VERSION__ >= 202311L */
 {
  /* Success. */
  CAROM_STATUS_OK = 0,
  /* A required pointer is null. */
  CAROM_STATUS_NULL_POINTER = 1,
  /* A pointer or a stride is not aligned to its type. */
  CAROM_STATUS_MISALIGNED = 2,
  /* A value is out of range; `carom_error` names the field. */
  CAROM_STATUS_OUT_OF_RANGE = 3,
  /* A state is not zero and was not written by this library. */
  CAROM_STATUS_BAD_STATE = 4,
  /* The bodies have no contact that this library can compute. */
  CAROM_STATUS_NO_CONTACT = 5,
  /* The impact could not be computed to separation. */
  CAROM_STATUS_NOT_FOLLOWED = 6,
  /* Internal error of this library; the results are not valid. */
  CAROM_STATUS_INTERNAL = 7
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_status carom_status;
#else
typedef int32_t carom_status;
#endif /* __STDC_VERSION__ >= 202311L */
#endif /* __cplusplus */

/* Describes an error: `text` is the message to print, `field` and `value` say what was wrong. Filled in by a
 * call that does not return `CAROM_STATUS_OK`, otherwise not changed. */
typedef struct carom_error {
  /* Index of the array entry, from 0; -1 if no array is concerned. */
  int64_t index;
  /* The value of the field; 0 if it has none. */
  double value;
  /* The name of the field or argument, or an empty string. Zero-terminated. */
  char field[40];
  /* The message, a sentence such as "friction = -1 is out of range: must be >= 0". Zero-terminated. */
  char text[200];
} carom_error;

/* A short text for each status. Never null, and not to be freed. */
const char *carom_status_text(int32_t status);

/* Raised whenever a structure or a function of this header changes. Compare it with `carom_abi_version()` of
 * the loaded library. */
#define CAROM_ABI_VERSION 13

/* The version of the numbers of a `carom_state` and of a packed touch; files of another version cannot be read. */
#define CAROM_STATE_VERSION 3

/* The version of the library, as "0.1.0"; not to be freed. */
const char *carom_version(void);

/* The version of the structures and functions of this library. */
uint32_t carom_abi_version(void);

/* ---- 2. Materials and the names of laws ---------------------------------------
 *
 * carom_law_of_name reads the name of a law in an input file. */

/* `coulomb`: exact return mapping at each depth of the contact, to a tolerance, for paths that turn. */
#define CAROM_LAW_COULOMB 0

/* `fixed-direction`: one direction of traction in a slip annulus (chapter 7 of the thesis). Exact on
 * straight paths; where the direction turns, the mean error is 5 % of the friction limit. Faster. */
#define CAROM_LAW_FIXED_DIRECTION 1

/* `rings`: approach, shift, twist and the coupling of dissimilar materials act together; the contact, a
 * circle, is divided into concentric rings. For particles (`carom_law_make`) only. A step takes 2 to 5
 * microseconds. With 100 steps in an impact the error of R_x is at most .01, unless the tangential velocity is
 * below f/2 times the normal one. */
#define CAROM_LAW_RINGS 2

/* An elastic material, or a rigid one. */
typedef struct carom_material {
  /* Young's modulus, Pa; infinite for a rigid body. */
  double young_modulus;
  /* Poisson's ratio, in (-1, 0.5]; ignored for a rigid body. */
  double poisson;
  /* Yield stress in tension, Pa; 0 if it is not known. All contacts stay elastic; CAROM_WARNING_YIELDS
   * tells where the material would yield. A hardness H is that of H/2.8. */
  double yield_stress;
} carom_material;

/* The CAROM_LAW constant of a name: "coulomb", "fixed-direction" or "rings".
 *
 * `name` must end with a zero. */
carom_status carom_law_of_name(const char *name, uint32_t *law, struct carom_error *error);

/* The name of a CAROM_LAW constant; empty for another number. Never null, and not to be freed. */
const char *carom_law_name(uint32_t law);

/* ---- 3. Contacts of particles: grains and walls -------------------------------
 *
 * carom_law_make makes the law of the contacts of two materials: friction, damping, torsion, resistance
 * to rolling; carom_law_on_curved_wall that of a grain at a curved wall. carom_touch_step makes one step
 * of a contact, whose memory has carom_touch_size bytes: positions, velocities and spins in, force and
 * torques out; carom_touch_step_many makes those of many. carom_touch_pack writes a contact as numbers. */

/* The constants of a rolling resistance: a spring and a dashpot side by side, in series with a slider.
 *
 * With the relative radius R (1/R = 1/radius_1 + 1/radius_2) and the normal n from body 2 into body 1 the bodies
 * roll with the velocity v = R (spin_1 - spin_2) x n. Spring and dashpot exert the force F = - stiffness s -
 * damping ds/dt, up to friction times the normal force, beyond which they slip: ds/dt = v without slip. The force
 * acts on no body; the torque on body 1 is R n x F, that on body 2 the opposite. The step of s is that of the
 * implicit Euler method. Where the bodies part, the energy of the spring becomes heat. */
typedef struct carom_rolling {
  /* The spring: force over the displacement of rolling, N/m. */
  double stiffness;
  /* The dashpot: force over the velocity of rolling, N s/m. */
  double damping;
  /* The slider: the greatest force over the normal force; 0 for no resistance. */
  double friction;
} carom_rolling;

/* Options of a law of particles. Zero in any field but `size` selects the default. */
typedef struct carom_law_options {
  /* `sizeof(carom_law_options)`. Later versions add fields at the end; a smaller `size` leaves these at zero. */
  size_t size;
  /* A CAROM_LAW constant; by default CAROM_LAW_COULOMB. */
  uint32_t law;
  /* 1: friction resists the spin about the normal, by a law with memory that neglects the shift, and costs three to
   * four times as much as a step without it. CAROM_LAW_RINGS always counts the spin. 0: it is left alone. */
  uint32_t torsion;
  /* CAROM_LAW_COULOMB: error of the friction force over its limit, by default 1e-2. CAROM_LAW_RINGS: relative
   * accuracy with which tractions satisfy the friction limit, by default 3e-3. */
  double tolerance;
  /* The coefficient of static friction, finite and at least `friction`; 0 if it is that of `friction`. Until all of a
   * contact slides, it sticks or slips in part with `static_friction`; then the force drops, and it slides with
   * `friction`. Where a part of it sticks, static friction counts again. Not with CAROM_LAW_RINGS or `torsion`. */
  double static_friction;
  /* Of friction that depends on the slip speed v of the first touch, f = a + b exp(-c v), a the argument `friction`:
   * b; 0 for a constant coefficient. a, a + b and c must be finite and at least 0. A contact keeps its coefficient
   * while it lasts. Not with static friction, CAROM_LAW_RINGS or `torsion`. */
  double slip_friction_b;
  /* Of friction by the slip speed: c, s/m. */
  double slip_friction_c;
  /* The viscous relaxation time A of the two bodies together, s. Every stress then has a viscous companion, A times
   * its rate. The normal force is K (zeta^(3/2) + (3/2) A sqrt(zeta) zeta'), K = (2/3) c_z, while the approach zeta
   * grows, and K (zeta + A zeta')^(3/2), or 0, while it falls; friction is damped alike. */
  double relaxation;
  /* Grains part with `restitution` times the speed with which they met, at any speed: from 0.01 to 1, which means no
   * damping, as 0. The force is alpha sqrt(m K) zeta^(1/4) dzeta/dt beside that of Hertz, K zeta^(3/2), m the reduced
   * mass; the sum never pulls. Friction is damped as in a viscous material, and leaves the restitution as it is. With
   * 50 steps in an impact the restitution is met to 2e-4. Not beside a relaxation time: both would count the same
   * loss. Masses of grains are read then, and must be > 0; that of one of both bodies must be finite. */
  double restitution;
  /* The resistance to rolling. */
  struct carom_rolling rolling;
} carom_law_options;

/* The law of all contacts of grains of two materials, of any radii, or of grains of material 1 and a wall of material
 * 2. It does not change, and may be used by several threads at once. It takes less than a kilobyte; with
 * CAROM_LAW_RINGS 60 more. */
typedef struct carom_law carom_law;

/* Makes the law of the contacts of grains of two materials, or of grains of material 1 and a wall of material 2.
 * `friction` is the coefficient of friction, finite; null `options` select the defaults: CAROM_LAW_COULOMB, without
 * damping, torsion or resistance to rolling. `carom_law_free` releases it.
 *
 * With CAROM_LAW_RINGS it takes a fraction of a millisecond, the first one 10 ms. */
carom_status carom_law_make(const struct carom_material *material_1,
                            const struct carom_material *material_2,
                            double friction,
                            const struct carom_law_options *options,
                            struct carom_law **law,
                            struct carom_error *error);

/* Makes the law of the contacts of grains of one radius R with a curved wall, from that with a flat one. The wall,
 * where it is nearest, has the curvature `curvature_x` along the axis x of the contact, `curvature_y` across it, 1/m;
 * above 0 where it is convex, as a shaft, below 0 where it is hollow, as a drum: then above -1/R. In calls that ask
 * for the radius of the wall it is infinite, as that of a flat one. CAROM_LAW_RINGS needs two equal curvatures; its
 * matrices are shared. `carom_law_free` releases the law; the flat one may be released before. */
carom_status carom_law_on_curved_wall(const struct carom_law *flat,
                                      double radius,
                                      double curvature_x,
                                      double curvature_y,
                                      struct carom_law **law,
                                      struct carom_error *error);

/* Releases a law; null is allowed.
 *
 * `law` must be null or made by this library, and is not to be used again. */
void carom_law_free(struct carom_law *law);

/* The place where a wall of any shape, at rest or moving, is nearest to a grain: its tangent plane there and its
 * motion. */
typedef struct carom_surface {
  /* The nearest point of the wall, m. */
  double place[3];
  /* Unit normal at that point, pointing towards the grain. */
  double normal[3];
  /* The velocity of the wall at that point, m/s. */
  double velocity[3];
  /* The angular velocity of the wall, rad/s. */
  double spin[3];
  /* The direction of the axis x of the contact, a unit vector across the normal, for an ellipse whose axes are
   * given by the wall. Zero for a circle, whose axes turn with the mean of the two spins. */
  double axis[3];
} carom_surface;

/* A sphere with its motion, as a particle code stores it. */
typedef struct carom_grain {
  /* Position of its centre, m. */
  double place[3];
  /* The velocity of its centre, m/s. */
  double velocity[3];
  /* Angular velocity, rad/s. */
  double spin[3];
  /* Its radius, m. */
  double radius;
  /* Its mass, kg; infinite for one that does not move. It counts for damping by a restitution only. */
  double mass;
} carom_grain;

/* Dissipated energy, by cause, J. Steps add to it. */
typedef struct carom_heats {
  /* Friction heat, including the energy released at a receding edge, and what a contact loses
   * where it simplifies its memory; a step may lower it a little. */
  double friction;
  /* Energy dissipated by the viscous material: the rest of the work. While a contact slips in part, the heat of friction is
   * ahead by the force times the lead of the shift, and this one behind by as much, which may make it negative. The sum of both
   * is right; the share of each errs with the loss and the length of the steps. In sliding impacts of 100 steps friction had 1.16
   * times the work of friction at e = 0.2, 1.45 times at e = 0.1, there 1.19 times in 800 steps. */
  double damping;
  /* Heat of a resistance to rolling. */
  double rolling;
} carom_heats;

/* The regime of the last step of a contact. */
enum carom_regime
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif /* defined(__cplusplus) || __STDC_VERSION__ >= 202311L */
 {
  /* The bodies are separated. */
  CAROM_REGIME_SEPARATED = 0,
  /* The whole contact sticks: its edge grew faster than the slip would. */
  CAROM_REGIME_ADHESION = 1,
  /* The edge receded, and the rest of the contact did not slip. */
  CAROM_REGIME_RELEASE = 2,
  /* An annulus at the edge slipped. */
  CAROM_REGIME_SLIP = 3,
  /* Slip began anew at the edge, in the opposite direction. */
  CAROM_REGIME_REVERSAL = 4,
  /* The slip annulus grew past older ones and erased them. */
  CAROM_REGIME_OVERLAY = 5,
  /* The whole contact slid. */
  CAROM_REGIME_SLIDING = 6
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum carom_regime carom_regime;
#else
typedef uint32_t carom_regime;
#endif /* __STDC_VERSION__ >= 202311L */
#endif /* __cplusplus */

/* The state of a contact beside its load. */
typedef struct carom_report {
  /* The share of the contact area that sticks. */
  double sticking;
  /* The regime of the last step. */
  carom_regime regime;
} carom_report;

/* The state of the contact of two grains, or of a grain and a wall, in memory of the caller: `carom_touch_size(law)`
 * bytes, aligned to 8, that may be copied as bytes. Zero bytes stand for two separated bodies. Only the build that
 * wrote it can read it, and only with a law of the same kind; `carom_touch_pack` converts it to numbers that any build
 * of this `CAROM_STATE_VERSION` can read.
 *
 * The constants are those of the step in which contact began. To change them, set the touch to zero. */
typedef struct carom_touch carom_touch;

/* The number of bytes of a touch of this law: 1272 of a law of shifts, 3296 of CAROM_LAW_RINGS; 752 more with torsion,
 * 72 more with a resistance to rolling. 0 for null. */
size_t carom_touch_size(const struct carom_law *law);

/* The load that body 2 exerts on body 1. */
typedef struct carom_grain_load {
  /* The force on body 1, N; the force on body 2 is opposite. */
  double force[3];
  /* The torque on body 1 about its centre, N m. */
  double torque_1[3];
  /* The torque on body 2 about its centre, N m; zero for a wall. */
  double torque_2[3];
} carom_grain_load;

/* One step of duration `dt` of the contact of a grain, body 1, with another grain, `two`, or with a wall of any shape,
 * `wall`, which may turn; the other one of both is null. Positions are those at the end of the step. Velocities are
 * those that led there; in a leapfrog scheme, those of the half step between. The heat of the step is added to
 * `heats`, which may be null; computing it costs several times the force, but nothing with CAROM_LAW_RINGS.
 *
 * Where the bodies separate, the history is lost; if heat is computed, it contains the energy released then. Bodies
 * that are separated and stay so need no call. Without damping, friction of the last four steps before is the mean over
 * each of them, as the motion needs it, and may exceed the friction limit of the force at their end. */
carom_status carom_touch_step(const struct carom_law *law,
                              struct carom_touch *touch,
                              const struct carom_grain *one,
                              const struct carom_grain *two,
                              const struct carom_surface *wall,
                              double dt,
                              struct carom_grain_load *load,
                              struct carom_heats *heats,
                              struct carom_error *error);

/* A grain, what it touches and their contact, for a call that advances many. */
typedef struct carom_encounter {
  /* The law of the contact. */
  const struct carom_law *law;
  /* The state of their contact; no two encounters may share one. */
  struct carom_touch *touch;
  /* The wall that body 1 touches; null for body 2. */
  const struct carom_surface *wall;
  /* Body 1. */
  struct carom_grain one;
  /* Body 2, unless there is a wall. */
  struct carom_grain two;
  /* Output: the load on body 1 at the end of the step. */
  struct carom_grain_load load;
} carom_encounter;

/* One step of duration `dt` for many contacts. Gives the same bits as `carom_touch_step` for each, in less time, since
 * several pairs of grains with laws of shifts share vector instructions.
 *
 * An encounter that fails ends the call, and `error->index` names it; those before it have been advanced.
 * The heat of all is added to `heats`, which may be null; computing it costs several times the force.
 *
 * `encounters` must have `count` entries, of which no two have the same touch. */
carom_status carom_touch_step_many(struct carom_encounter *encounters,
                                   size_t count,
                                   double dt,
                                   struct carom_heats *heats,
                                   struct carom_error *error);

/* The load of two bodies after the last step, without a new one: the same bits if the positions are the same. A touch
 * that is zero carries only the force of Hertz. Body 2 is `two` or `wall`, as in `carom_touch_step`. */
carom_status carom_touch_load(const struct carom_law *law,
                              const struct carom_touch *touch,
                              const struct carom_grain *one,
                              const struct carom_grain *two,
                              const struct carom_surface *wall,
                              struct carom_grain_load *load,
                              struct carom_error *error);

/* The elastic energy of a contact, J: of compression, of the tangential load, of twist and of rolling. The radius of a
 * wall is infinite. */
carom_status carom_touch_energy(const struct carom_law *law,
                                const struct carom_touch *touch,
                                double radius_1,
                                double radius_2,
                                double *energy,
                                struct carom_error *error);

/* The share of the contact that sticks, and the regime of the last step; with CAROM_LAW_RINGS separated, adhesion, slip
 * or sliding. */
carom_status carom_touch_report(const struct carom_law *law,
                                const struct carom_touch *touch,
                                struct carom_report *report,
                                struct carom_error *error);

/* The number of numbers into which a touch of this law packs: 82 of a law of shifts, 319 of CAROM_LAW_RINGS; 83 more
 * with torsion, 9 with a resistance to rolling, 1 with friction by the slip speed. 0 for null. */
size_t carom_touch_pack_size(const struct carom_law *law);

/* Writes a touch as `carom_touch_pack_size(law)` numbers. All are zero for separated bodies; otherwise the first is
 * positive.
 *
 * `numbers` must have room for all of them. */
carom_status carom_touch_pack(const struct carom_law *law,
                              const struct carom_touch *touch,
                              double *numbers,
                              struct carom_error *error);

/* Makes a touch from the numbers of `carom_touch_pack`. The options of the law and the radii must be the same as then;
 * the radius of a wall is infinite. The contact continues as the packed one, but for the
 * rounding of sums; contacts made from the same numbers continue with the same bits.
 *
 * `numbers` must have `carom_touch_pack_size(law)` entries. */
carom_status carom_touch_unpack(const struct carom_law *law,
                                double radius_1,
                                double radius_2,
                                const double *numbers,
                                struct carom_touch *touch,
                                struct carom_error *error);

/* ---- 4. Surfaces of triangles -------------------------------------------------
 *
 * carom_mesh_make makes a surface of triangles, carom_mesh_places finds where a ball touches it: places and
 * normals of the walls of carom_touch_step. */

/* `carom_place.part`: the inside of a face. */
#define CAROM_PART_FACE 0

/* `carom_place.part`: an edge between its ends. */
#define CAROM_PART_EDGE 1

/* `carom_place.part`: a corner. */
#define CAROM_PART_CORNER 2

/* A surface of triangles, with the memory of a search: it may be used by one thread at a time. It takes about 450 bytes
 * a triangle. */
typedef struct carom_mesh carom_mesh;

/* A place where a ball touches a surface. */
typedef struct carom_place {
  /* The point of the surface. */
  double point[3];
  /* The unit normal from there to the centre of the ball. */
  double normal[3];
  /* The distance of the centre from the point. */
  double distance;
  /* The ends of an edge in the given triangles; of a corner twice itself, of a face twice a point of its plane that is
   * the same for all places on it. */
  double ends[2][3];
  /* Where the surface repeats itself: how far the copy that is touched is from the given triangles; else zero. */
  double shift[3];
  /* A `CAROM_PART_...`. */
  uint32_t part;
  /* Which one, from 0; of a face the triangle. */
  uint32_t number;
  /* 1 if it is an edge or a corner where triangles meet at more than the smooth angle, or end; else 0. */
  uint32_t is_sharp;
} carom_place;

/* Makes a surface of `count` triangles, nine numbers for each: three corners in any order. Corners with the same
 * coordinates are one, triangles in one plane are one face, and both sides count. Places whose normals differ by less
 * than `smooth`, from .01 to .8 rad, are one place. `period`, if not null, has three numbers: the lengths after which
 * the surface repeats itself along the axes, 0 for none; shorter than the surface they are refused. `carom_mesh_free`
 * releases the surface.
 *
 * `triangles` must have 9 `count` entries. */
carom_status carom_mesh_make(const double *triangles,
                             size_t count,
                             double smooth,
                             const double *period,
                             struct carom_mesh **mesh,
                             struct carom_error *error);

/* The places where a ball with this centre touches the surface whose distance from the centre is at most `reach`:
 * where the surface is nearer than anywhere close by, within a face, on an edge or at a corner. The first `room` of them
 * are written to `places`, faces first, as their triangles were given; `count` is their number, which may be greater.
 * It allocates nothing once it has found as much before.
 *
 * `center` must have 3 entries, `places` `room`; `mesh` must be made by this library and not yet freed. */
carom_status carom_mesh_places(struct carom_mesh *mesh,
                               const double *center,
                               double reach,
                               struct carom_place *places,
                               size_t room,
                               size_t *count,
                               struct carom_error *error);

/* Releases a surface; null is allowed.
 *
 * `mesh` must be null or made by this library, and is not to be used again. */
void carom_mesh_free(struct carom_mesh *mesh);

/* ---- 5. Contacts with given shifts --------------------------------------------
 *
 * carom_pair_of_spheres and carom_pair_of_curvatures make the constants of a contact from the
 * materials and the shape. carom_contact_advance moves a contact to a new approach and shift and returns
 * the load; carom_contact_advance_many does so for an array. */

/* The constants of a contact: plain data, made by the functions `carom_pair_of_...` and not to be changed
 * otherwise. Units are SI, or any consistent set. */
typedef struct carom_pair {
  /* Tangential stiffness along x, N/m^1.5: in full adhesion dF_x = c_x sqrt(zeta) dxi. */
  double c_x;
  /* Tangential stiffness along y, N/m^1.5. */
  double c_y;
  /* Normal stiffness, N/m^1.5: F_z = (2/3) c_z zeta^1.5. */
  double c_z;
  /* The coefficient of friction, from 0 to infinity (no slip). */
  double friction;
  /* CAROM_LAW_COULOMB: error of the friction force over its limit. */
  double tolerance;
  /* a^2/zeta of the contact ellipse, m. */
  double a_squared;
  /* b^2/zeta of the contact ellipse, m. */
  double b_squared;
  /* Gamma, the coupling of normal and tangential displacements (15.2); 0 for like materials. */
  double gamma;
  /* Upper bound of the change of R_x by coupling in an impact of spheres, which the law neglects. */
  double coupling_bound;
  /* CAROM_LAW_COULOMB or CAROM_LAW_FIXED_DIRECTION. */
  uint32_t law;
  /* CAROM_ABI_VERSION of the library that made the pair. */
  uint32_t version;
} carom_pair;

/* The constants of two spheres, of a sphere on a plane (one radius infinite) or in a spherical cavity (one
 * radius negative). A `tolerance` of 0 selects the default for particles: 1e-2. */
carom_status carom_pair_of_spheres(const struct carom_material *material_1,
                                   const struct carom_material *material_2,
                                   double radius_1,
                                   double radius_2,
                                   double friction,
                                   uint32_t law,
                                   double tolerance,
                                   struct carom_pair *pair,
                                   struct carom_error *error);

/* The constants of two bodies with the gap A x^2 + B y^2; A and B in 1/m. */
carom_status carom_pair_of_curvatures(const struct carom_material *material_1,
                                      const struct carom_material *material_2,
                                      double curvature_a,
                                      double curvature_b,
                                      double friction,
                                      uint32_t law,
                                      double tolerance,
                                      struct carom_pair *pair,
                                      struct carom_error *error);

/* Rigid displacement of body 2 relative to body 1 in contact axes; z points into body 1. */
typedef struct carom_shift {
  /* The approach, positive in contact, m. */
  double zeta;
  /* The shift along x, m. */
  double xi;
  /* The shift along y, m. */
  double eta;
} carom_shift;

/* The load that body 2 exerts on body 1. */
typedef struct carom_load {
  /* Tangential force along x, N. */
  double f_x;
  /* Tangential force along y, N. */
  double f_y;
  /* Normal force, positive in compression, N. */
  double f_z;
} carom_load;

/* Number of numbers in a `carom_state`. */
#define CAROM_STATE_NUMBERS 66

/* The state of a contact as 66 numbers, in memory of the caller; zeros stand for two bodies that just touch,
 * without shift. The numbers mean the same on any machine and in any build of this `CAROM_STATE_VERSION`,
 * so that they can be stored in files and sent to other processes. `carom_contact_pack` writes them;
 * `carom_contact_unpack` makes a contact from them, which continues with the same bits. The friction of the
 * pair must be finite. */
typedef struct carom_state {
  /* Written by this library only. */
  double numbers[CAROM_STATE_NUMBERS];
} carom_state;

/* Number of 8-byte words in a `carom_contact`, without its mark. */
#define CAROM_CONTACT_WORDS 144

/* The state of a contact in memory of the caller: 1160 bytes, aligned to 8, that may be copied as bytes.
 * Zero bytes stand for two bodies that just touch, without shift.
 *
 * It stores the law with its constants, so that a step reads and writes only what it needs. Only the build
 * that wrote it can read it; `carom_contact_pack` converts it to a `carom_state`.
 *
 * The constants are those of the pair of the first advance. To change them, set the contact to zero. */
typedef struct carom_contact {
  /* Identifies the build that wrote the contact. Written by this library only. */
  uint64_t mark;
  /* The bytes of the law. */
  uint64_t words[CAROM_CONTACT_WORDS];
} carom_contact;

/* Moves the contact straight from the present shift to a new one. `load` may be null.
 *
 * A `zeta` that is not positive separates the bodies, and the history is lost. */
carom_status carom_contact_advance(const struct carom_pair *pair,
                                   struct carom_contact *contact,
                                   struct carom_shift shift,
                                   struct carom_load *load,
                                   struct carom_error *error);

/* The present load. */
carom_status carom_contact_load(const struct carom_pair *pair,
                                const struct carom_contact *contact,
                                struct carom_load *load,
                                struct carom_error *error);

/* The elastic energy of the contact, compression included, J. */
carom_status carom_contact_energy(const struct carom_pair *pair,
                                  const struct carom_contact *contact,
                                  double *energy,
                                  struct carom_error *error);

/* Writes the state of a contact as plain numbers, for a file or another process. */
carom_status carom_contact_pack(const struct carom_pair *pair,
                                const struct carom_contact *contact,
                                struct carom_state *state,
                                struct carom_error *error);

/* Makes a contact from a stored state. A contact that is not zero keeps its constants, which is faster: one
 * contact may read many states of a pair in turn. */
carom_status carom_contact_unpack(const struct carom_pair *pair,
                                  const struct carom_state *state,
                                  struct carom_contact *contact,
                                  struct carom_error *error);

/* Advances many contacts of one pair, contact i by shift i. A stride is the number of bytes from one entry
 * to the next, so that the arrays may be columns of larger structures. `loads` may be null.
 *
 * All shifts are checked before any contact is advanced: if one is out of range, nothing is changed and
 * `error->index` names it. An invalid contact ends the call at its index; those before it have been
 * advanced.
 *
 * `contacts`, `shifts` and, unless null, `loads` must have `count` entries, of which no two overlap. */
carom_status carom_contact_advance_many(const struct carom_pair *pair,
                                        size_t count,
                                        struct carom_contact *contacts,
                                        size_t contact_stride,
                                        const struct carom_shift *shifts,
                                        size_t shift_stride,
                                        struct carom_load *loads,
                                        size_t load_stride,
                                        struct carom_error *error);

/* ---- 6. Impacts ---------------------------------------------------------------
 *
 * carom_collide computes the impact of two bodies. */

/* Chooses the cheapest law that accounts for the coupling of dissimilar materials. For spheres and planes
 * that is CAROM_IMPACT_RINGS where coupling matters. For other shapes coupling is neglected, and
 * CAROM_WARNING_COUPLING reports it. */
#define CAROM_IMPACT_AUTO 0

/* The law `coulomb` for any materials: coupling is neglected. */
#define CAROM_IMPACT_COULOMB 1

/* The law `fixed-direction` for any materials: coupling is neglected. */
#define CAROM_IMPACT_FIXED_DIRECTION 2

/* The law `rings`, for spheres and planes only: it includes coupling and the spin about the normal. */
#define CAROM_IMPACT_RINGS 3

/* With CAROM_IMPACT_AUTO friction changes the spin about the normal where that matters; with other laws it
 * does not. */
#define CAROM_TORSION_AUTO 0

/* The spin about the normal is changed by a torsional impact that is computed as if there were no tangential
 * one. */
#define CAROM_TORSION_INCLUDED 1

/* The spin about the normal is not changed. */
#define CAROM_TORSION_LEFT_OUT 2

/* No energy is dissipated in the material of the bodies. */
#define CAROM_LOSS_NONE 0

/* The material is viscous: the normal velocity after the impact is `normal_restitution`, in [0, 1], times that before,
 * where normal and tangential motion are uncoupled. */
#define CAROM_LOSS_GIVEN 1

/* The energy that elastic waves carry away is lost, see CAROM_WARNING_WAVE_LOSS; `normal_restitution` is
 * ignored. */
#define CAROM_LOSS_BY_WAVES 2

/* The material is viscous with a relaxation time, `relaxation`: the normal restitution falls as the speed grows;
 * `normal_restitution` is ignored. */
#define CAROM_LOSS_VISCOELASTIC 3

/* The bodies yield: the elastic impulse times (1 + e)/2, e the `normal_restitution`, in [0, 1]. */
#define CAROM_LOSS_YIELD 4

/* As CAROM_LOSS_GIVEN, of a material whose stress relaxes wholly (Maxwell). Like CAROM_LOSS_STANDARD_SOLID and
 * CAROM_LOSS_CONSTANT_TANGENT for like spheres and planes without spin about the normal, and from 0.1. */
#define CAROM_LOSS_MAXWELL 5

/* As CAROM_LOSS_GIVEN, of a standard solid whose stress relaxes fast to a tenth. */
#define CAROM_LOSS_STANDARD_SOLID 6

/* As CAROM_LOSS_GIVEN, of a material whose loss tangent is the same at any frequency. */
#define CAROM_LOSS_CONSTANT_TANGENT 7

/* Options of an impact. Zero in any field but `size` selects the default. */
typedef struct carom_collide_options {
  /* `sizeof(carom_collide_options)`. Later versions add fields at the end; a smaller `size` leaves these
   * at zero. */
  size_t size;
  /* The contact law, a CAROM_IMPACT constant. */
  uint32_t law;
  /* The loss in the material, beyond the elastic theory, a CAROM_LOSS constant. With CAROM_LOSS_YIELD duration, force
   * and approach are those of the elastic impact. */
  uint32_t loss;
  /* The normal velocity after the impact over that before, for CAROM_LOSS_GIVEN, CAROM_LOSS_YIELD and the
   * materials after it: 1 is elastic, 0 leaves the bodies together. */
  double normal_restitution;
  /* Largest error of the contact velocity after the impact, over that before; 0 for the default. Rings that do
   * not reach it set CAROM_WARNING_NOT_SETTLED. */
  double tolerance;
  /* How friction acts on the spin about the normal, a CAROM_TORSION constant. CAROM_IMPACT_RINGS counts it unless
   * it is left out. */
  uint32_t torsion;
  /* The viscous relaxation time of both bodies together for CAROM_LOSS_VISCOELASTIC, s. */
  double relaxation;
  /* The coefficient of static friction, above which all of a contact slides with `friction`; 0 if it is that
   * of `friction`. Not with CAROM_IMPACT_RINGS or CAROM_TORSION_INCLUDED. */
  double static_friction;
  /* Of friction that depends on the slip speed v at the first touch, f = a + b exp(-c v), a the argument
   * `friction`: b; 0 for a constant coefficient. Not beside static friction. */
  double slip_friction_b;
  /* Of friction by the slip speed: c, s/m. */
  double slip_friction_c;
} carom_collide_options;

/* A sphere: `sizes[0]` is its radius. */
#define CAROM_SHAPE_SPHERE 0

/* A fixed plane bounding a half-space; its axis c is the outward normal. */
#define CAROM_SHAPE_PLANE 1

/* An ellipsoid: `sizes` are its semi-axes. */
#define CAROM_SHAPE_ELLIPSOID 2

/* A cylinder about its axis c: radius and length. */
#define CAROM_SHAPE_CYLINDER 3

/* A cylinder between two half spheres, about its axis c: radius, and length of the straight part. */
#define CAROM_SHAPE_CAPSULE 4

/* A torus about its axis c: radius of the centre circle, radius of the tube. */
#define CAROM_SHAPE_TORUS 5

/* A box: `sizes` are its edge lengths. Contact at its edges and corners is not computed. */
#define CAROM_SHAPE_BOX 6

/* A body before a collision. Zero fields take the defaults: a solid at the origin, at rest, its axes along
 * those of space. */
typedef struct carom_body {
  /* The shape, a CAROM_SHAPE constant. */
  uint32_t shape;
  /* 1 for a thin shell, 0 for a solid. */
  uint32_t hollow;
  /* The dimensions of the shape, m; see the CAROM_SHAPE constants. */
  double sizes[3];
  /* The mass, kg; infinite for a fixed body. Ignored for a plane. */
  double mass;
  /* The principal moments of inertia, kg m^2; zeros for those of a homogeneous body. */
  double moments[3];
  /* The material. */
  struct carom_material material;
  /* The centre of mass, m; for a plane any of its points. */
  double centre[3];
  /* The unit quaternion (w, i, j, k) that transforms components in body axes to space axes; zeros for no
   * rotation. */
  double attitude[4];
  /* The velocity of the centre of mass, m/s. */
  double velocity[3];
  /* The angular velocity in space axes, rad/s. */
  double spin[3];
} carom_body;

/* The result of an impact. Relative velocities at the contact are of body 2 against body 1. Columns of the
 * command `carom` and fields of Python's `Rebound` have the same names. */
typedef struct carom_rebound {
  /* 1 if the bodies collide. 0 if they do not approach each other: then only point, normal and motions are
   * given. */
  uint32_t collides;
  /* The CAROM_WARNING bits that apply. */
  uint32_t warnings;
  /* The velocity of the centre of mass of body 1 after the impact, m/s. */
  double body_1_velocity[3];
  /* The angular velocity of body 1 after the impact, rad/s. */
  double body_1_spin[3];
  /* The velocity of the centre of mass of body 2 after the impact, m/s. */
  double body_2_velocity[3];
  /* The angular velocity of body 2 after the impact, rad/s. */
  double body_2_spin[3];
  /* The impulse that body 2 exerts on body 1, N s. */
  double impulse[3];
  /* The contact point, m. */
  double point[3];
  /* The unit normal at the contact point, from body 2 into body 1. */
  double normal[3];
  /* The relative velocity of the contact points before the impact, m/s. */
  double contact_velocity_before[3];
  /* The relative velocity of the contact points after the impact, m/s. */
  double contact_velocity_after[3];
  /* Minus the tangential velocity of the contact after the impact over that before; valid if `has_R_x` is
   * 1. */
  double R_x;
  /* 1 if R_x is defined. */
  uint32_t has_R_x;
  /* Number of compression phases, each a maximum of the approach. */
  uint32_t compressions;
  /* The time from first contact to separation, s. */
  double duration;
  /* The maximum normal force, N. */
  double maximal_force;
  /* The maximum approach, m. */
  double maximal_approach;
  /* The semi-axis of the largest contact ellipse along x of the contact, the smaller one, m. */
  double maximal_semi_axis_a;
  /* The semi-axis of the largest contact ellipse along y of the contact, m. */
  double maximal_semi_axis_b;
  /* The kinetic energy before the impact, J. */
  double energy_before;
  /* The kinetic energy after the impact, J. */
  double energy_after;
  /* The energy dissipated by friction, J. */
  double energy_dissipated;
  /* The energy dissipated in the material of the bodies, J; 0 for elastic bodies. */
  double energy_lost;
  /* Estimated error of the velocity after the impact over that before; 0 for an exact solution. */
  double error_estimate;
  /* How far R_x may be off by another cause of the loss along the normal; 0 for elastic bodies and a given cause. */
  double model_uncertainty;
  /* The relative spin about the normal after the impact over that before; valid if `has_torsion` is 1. */
  double spin_ratio;
  /* The angular impulse on body 1 about the normal, N m s; valid if `has_torsion` is 1. */
  double torque_impulse;
  /* 1 if friction was applied to the spin about the normal. */
  uint32_t has_torsion;
} carom_rebound;

/* Computes the impact of two bodies that touch at their given positions. If `normal` is not null, body 1 is
 * first moved into contact with body 2 such that this is the common normal, from body 2 into body 1.
 *
 * `options` may be null for the defaults: elastic bodies; for spheres and planes the coupling of normal and
 * tangential displacements of dissimilar materials counts where it matters, and with it the spin about the
 * normal.
 *
 * `normal` must be null or have three numbers. `options` must be null or have as many bytes as its `size`
 * says. */
carom_status carom_collide(const struct carom_body *body_1,
                           const struct carom_body *body_2,
                           double friction,
                           const double *normal,
                           const struct carom_collide_options *options,
                           struct carom_rebound *rebound,
                           struct carom_error *error);

/* ---- 7. R_x of spheres --------------------------------------------------------
 *
 * R_x is minus the tangential velocity of the contact after an impact over that before. */

/* R_x from the table: within 1e-8 of the exact impact, in tens of nanoseconds. */
#define CAROM_BY_TABLE 0

/* R_x by the exact impact, in microseconds. */
#define CAROM_EXACT 1

/* R_x of dissimilar spheres by rings, in milliseconds. */
#define CAROM_BY_RINGS 2

/* R_x, the tangential velocity after an impact of solid spheres over that before, reversed in sign.
 *
 * `kappa` = (2 - nu)/(2 (1 - nu)) is that of the materials, in (0.75, 1.5]; `lambda` >= 0 the
 * tangential velocity of the contact over f times the normal one; `normal_restitution`, in [0, 1], is e of a viscous
 * material, 1 of an elastic one. `method` is CAROM_BY_TABLE (with a loss within 3e-3) or CAROM_EXACT (within 1e-5). */
carom_status carom_restitution(double kappa,
                               double lambda,
                               double normal_restitution,
                               uint32_t method,
                               double *restitution,
                               struct carom_error *error);

/* R_x of many pairs of `kappa` and `lambda`, with one `normal_restitution`. The strides are the bytes from one entry to the next; 0
 * takes the same entry again and again. The first pair without an answer ends the call:
 * `error->index` names it, and those before it have been written.
 *
 * `kappa`, `lambda` and `restitution` must have `count` entries; those of `restitution` must overlap
 * nothing. */
carom_status carom_restitution_many(size_t count,
                                    const double *kappa,
                                    size_t kappa_stride,
                                    const double *lambda,
                                    size_t lambda_stride,
                                    double normal_restitution,
                                    uint32_t method,
                                    double *restitution,
                                    size_t restitution_stride,
                                    struct carom_error *error);

/* R_x of spheres or planes of dissimilar materials without spin about the normal.
 *
 * `gamma`, of either sign, is the coupling (15.2) of the materials, at most 3/2 - `kappa`, which is in
 * [0.75, 1.5]. `friction` is f, from 0 to infinity; `lambda` >= 0 as for `carom_restitution`, 0 where f is
 * infinite. `mobility_ratio`, in (0, 75], is D_xx/D_zz: 3.5 of solid spheres, 2.5 of hollow ones.
 *
 * `method` tells how it was found, and `error_estimate` how far it may be off; each may be null:
 * - CAROM_EXACT: gamma = 0, with the bits of `carom_restitution`, or no friction.
 * - CAROM_BY_TABLE: in half a microsecond, for kappa from 1, lambda to 8, f to 1, |gamma|/f to 12 and
 *   mobility_ratio from 1 to 6.
 * - CAROM_BY_RINGS: elsewhere, by time steps, in milliseconds to seconds. */
carom_status carom_restitution_dissimilar(double kappa,
                                          double gamma,
                                          double friction,
                                          double lambda,
                                          double mobility_ratio,
                                          double *restitution,
                                          double *error_estimate,
                                          uint32_t *method,
                                          struct carom_error *error);

/* ---- 8. Creep forces of a rolling contact -------------------------------------
 *
 * carom_creep_coefficients gives the forces of a wheel on a rail, or of any rolling bodies, at small
 * creepage, carom_creep_force at any creepage and spin. */

/* Creep coefficients of two equal bodies of shear modulus G, on an elliptical contact with semi-axes a along
 * the direction of rolling and b across it: forces on body 1 at creepages xi, eta (sliding velocity of body 2
 * against body 1 over the rolling speed) and phi (spin, rad per length rolled) that are small. */
typedef struct carom_creep {
  /* F_x = G a b c11 xi. */
  double c11;
  /* F_y = G a b c22 eta. */
  double c22;
  /* F_y = -G (ab)^1.5 c23 phi, and M_z = G (ab)^1.5 c23 eta. Kalker's C23, and his -C32. */
  double c23;
  /* M_z = G (ab)^2 c33 phi. */
  double c33;
} carom_creep;

/* Forces of steady rolling on body 1. */
typedef struct carom_creep_force_result {
  /* Along the direction of rolling, N. */
  double f_x;
  /* Across it, N. */
  double f_y;
  /* Torque about the normal, N m. */
  double m_z;
  /* How far each force may be off, N; the torque by sqrt(ab) times as much. */
  double error;
} carom_creep_force_result;

/* Kalker's creep coefficients, from a table, in less than a microsecond.
 *
 * `axis_ratio` is a/b, from 0.05 to 20, with a along the direction of rolling; `poisson` that of both bodies,
 * from 0 to 0.5. Neither they nor the coefficients have units. An exchange of a and b is another contact: no
 * coefficient follows from those of b/a. */
carom_status carom_creep_coefficients(double axis_ratio,
                                      double poisson,
                                      struct carom_creep *coefficients,
                                      struct carom_error *error);

/* Creep forces of an elliptical contact of two bodies of like materials at any creepage and spin, from a table, in
 * microseconds and without allocation.
 *
 * `semi_axes` are a along the direction of rolling and b across it in m, a/b from 0.1 to 10; `shear_modulus` in Pa and
 * `poisson`, from 0 to 0.5, are those of each body; `friction` and `normal_force` in N are > 0. `creepages` are those of body 2
 * against body 1: along, across, and spin in rad/m.
 *
 * `semi_axes` must have 2 and `creepages` 3 entries. */
carom_status carom_creep_force(const double *semi_axes,
                               double shear_modulus,
                               double poisson,
                               double friction,
                               double normal_force,
                               const double *creepages,
                               struct carom_creep_force_result *force,
                               struct carom_error *error);

/* ---- 9. Limits of the theory --------------------------------------------------
 *
 * Warnings of an impact are bits of carom_rebound; carom_warning_text gives their words.
 * carom_law_validity tells whether a contact is small enough for Hertz's theory,
 * carom_law_impact_validity whether an impact is slow enough and its time step short enough;
 * carom_validity_text says it in a sentence. carom_law_impact_time tells how long an impact lasts. */

/* Normal and tangential displacements are coupled by the materials; the result neglects this. */
#define CAROM_WARNING_COUPLING 1

/* The contact is not small compared with the bodies: a/R exceeds 0.1, beyond Hertz's theory. */
#define CAROM_WARNING_LARGE_CONTACT 2

/* Elastic waves would carry away more than 1 % of the normal energy. */
#define CAROM_WARNING_WAVE_LOSS 4

/* Friction was not applied to the spin about the normal, although torsion would take more than 1 % of it. */
#define CAROM_WARNING_SPIN_LEFT_ALONE 8

/* The outcome did not converge to its tolerance. */
#define CAROM_WARNING_NOT_SETTLED 16

/* The contact point was found by sampling the surfaces; the bodies may touch elsewhere too. */
#define CAROM_WARNING_POINT_SAMPLED 32

/* The approach exceeds a tenth of the radius: the bodies are no half-spaces, and the result is approximate at
 * best. Check the units. */
#define CAROM_WARNING_LARGE_APPROACH 64

/* The greatest pressure exceeds 1.6 times the yield stress of the weaker body, from which metals flow below
 * the surface. */
#define CAROM_WARNING_YIELDS 128

/* The time step is too long: an impact lasts fewer than 20 steps. */
#define CAROM_WARNING_TIME_STEP 256

/* The spin about the normal uses up friction, which the law leaves out: R_x may change by more than 0.005. */
#define CAROM_WARNING_SPIN_ON_SHIFT 512

/* The cause of the loss along the normal is not given, and another one would change the velocity after the impact by more
 * than 5 % of that before. */
#define CAROM_WARNING_UNKNOWN_LOSS 1024

/* How far a contact or an impact lies within the theory, which holds for elastic contacts that are small
 * compared with the bodies, and how much the result leaves out. R is the smallest radius of curvature of the
 * two bodies at the contact. A ratio is 0 where it does not apply. Of many contacts take the largest of each. */
typedef struct carom_validity {
  /* a/R: the larger semi-axis of the contact over R. Hertz's theory requires at most 0.1. */
  double semi_axis_over_radius;
  /* zeta/R: the approach over R. Above 0.1 the result is approximate at best, above 1 meaningless. */
  double approach_over_radius;
  /* The greatest pressure over 1.6 times the smaller yield stress of the bodies, where metals begin to
   * flow; 0 if no yield stress is known. */
  double pressure_over_yield;
  /* The share of the normal energy of an impact that elastic waves would carry away; worth a warning
   * above 0.01. */
  double wave_share;
  /* Upper bound of the change of R_x by the coupling of dissimilar materials, if the law neglects it; worth
   * a warning above 0.005. */
  double coupling;
  /* The time step over the duration of the impact, at most 1/20. */
  double step_over_duration;
  /* The CAROM_WARNING bits of the ratios that exceed their limits; 0 if none does. */
  uint32_t warnings;
} carom_validity;

/* A sentence for one CAROM_WARNING bit. Never null, and not to be freed. */
const char *carom_warning_text(uint32_t warning);

/* The sentence for one CAROM_WARNING bit with the number of a `carom_validity`, cut to `size` bytes with a
 * zero at the end; empty if that ratio does not exceed its limit. 200 bytes are enough.
 *
 * `text` must have `size` bytes. */
carom_status carom_validity_text(const struct carom_validity *validity,
                                 uint32_t warning,
                                 char *text,
                                 size_t size,
                                 struct carom_error *error);

/* The duration of an elastic impact of two grains without damping, s: whoever steps it chooses the time step
 * from this. The second is a wall if its radius is infinite; a mass may be infinite, not both. `velocity` is
 * that of approach, above 0. */
carom_status carom_law_impact_time(const struct carom_law *law,
                                   double radius_1,
                                   double radius_2,
                                   double mass_1,
                                   double mass_2,
                                   double velocity,
                                   double *time,
                                   struct carom_error *error);

/* Whether the contact of two grains at the approach `zeta` (m, at least 0) lies within Hertz's theory. The
 * second is a wall if its radius is infinite. */
carom_status carom_law_validity(const struct carom_law *law,
                                double radius_1,
                                double radius_2,
                                double zeta,
                                struct carom_validity *validity,
                                struct carom_error *error);

/* How far an impact of two grains, which approach with `velocity` (above 0), lies within the theory, and
 * whether a time step of this duration, s, resolves it; 0 for no steps. Radii and masses are as in
 * `carom_law_impact_time`.
 *
 * The largest contact and the share of elastic waves are those without damping: they are 0 if the law is damped, which
 * stands for all losses. The density of the grains follows from mass and radius; waves in a wall are left out. */
carom_status carom_law_impact_validity(const struct carom_law *law,
                                       double radius_1,
                                       double radius_2,
                                       double mass_1,
                                       double mass_2,
                                       double velocity,
                                       double step,
                                       struct carom_validity *validity,
                                       struct carom_error *error);

/* The worst of many contacts, in each ratio, by their present places. Their touches are not read.
 *
 * `encounters` must have `count` entries. */
carom_status carom_encounters_validity(const struct carom_encounter *encounters,
                                       size_t count,
                                       struct carom_validity *validity,
                                       struct carom_error *error);

#ifdef __cplusplus
}
#endif

#endif /* CAROM_H */
