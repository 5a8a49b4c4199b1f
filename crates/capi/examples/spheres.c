/* Two glass spheres collide obliquely, stepped in time as a particle code does it.
 *
 *     cc spheres.c $(pkg-config --cflags --libs carom) -lm -o spheres
 *
 * Prints R_x and the balance of energy, compares R_x with the exact impact, and exits with 1 if one
 * is wrong.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "carom.h"

static int failures = 0;

static void must(int holds, const char *what) {
  if (!holds) {
    printf("wrong: %s\n", what);
    failures += 1;
  }
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* to = to + factor a. */
static void add(double to[3], double factor, const double a[3]) {
  int k;
  for (k = 0; k < 3; ++k) to[k] += factor * a[k];
}

static double kinetic(const carom_grain *ball, double mass, double inertia) {
  return 0.5 * (mass * dot(ball->velocity, ball->velocity) + inertia * dot(ball->spin, ball->spin));
}

/* The velocity of the surface of ball 2 against that of ball 1 along x, where they touch. The normal
 * is z, from ball 2 into ball 1. */
static double sliding(const carom_grain *one, const carom_grain *two) {
  return two->velocity[0] + two->radius * two->spin[1] -
         (one->velocity[0] - one->radius * one->spin[1]);
}

/* ANCHOR: setup */
static const carom_material glass = {70e9, 0.22, 0}; /* Young's modulus, Poisson's ratio, no yield stress */
static const double friction = 0.2, radius = 1e-3, density = 2500.0;

/* Ball 1 lies on top of ball 2 and comes down with 0.5 m/s, sideways with 0.2 m/s. */
static void start(carom_grain *one, carom_grain *two) {
  memset(one, 0, sizeof *one);
  memset(two, 0, sizeof *two);
  one->radius = two->radius = radius;
  one->place[2] = 2.0 * radius;
  one->velocity[0] = 0.2;
  one->velocity[2] = -0.5;
}
/* ANCHOR_END: setup */

/* The exact impact: R_x and the duration. */
static carom_rebound exact(double mass) {
  carom_grain one, two;
  carom_body bodies[2];
  carom_rebound rebound;
  carom_error error;
  start(&one, &two);
  memset(bodies, 0, sizeof bodies);
  bodies[0].shape = bodies[1].shape = CAROM_SHAPE_SPHERE;
  bodies[0].sizes[0] = bodies[1].sizes[0] = radius;
  bodies[0].mass = bodies[1].mass = mass;
  bodies[0].material = bodies[1].material = glass;
  memcpy(bodies[0].centre, one.place, sizeof one.place);
  memcpy(bodies[0].velocity, one.velocity, sizeof one.velocity);
  if (carom_collide(&bodies[0], &bodies[1], friction, NULL, NULL, &rebound, &error) !=
      CAROM_STATUS_OK) {
    printf("%s\n", error.text);
    failures += 1;
    memset(&rebound, 0, sizeof rebound);
  }
  return rebound;
}

/* ANCHOR: steps */
/* The load on ball 1, and its opposite on ball 2, change the velocities for a time dt. */
static void kick(carom_grain *one, carom_grain *two, const carom_grain_load *load, double mass,
                 double inertia, double dt) {
  add(one->velocity, dt / mass, load->force);
  add(two->velocity, -dt / mass, load->force);
  add(one->spin, dt / inertia, load->torque_1);
  add(two->spin, dt / inertia, load->torque_2);
}

/* Steps the impact by leapfrog until the balls separate. Returns R_x. */
static double step(double mass, double inertia, double dt) {
  carom_law *law;                      /* that of glass on glass */
  carom_touch *touch;                  /* the memory of this contact: zero bytes before contact */
  carom_grain one, two;                /* positions, velocities, spins */
  carom_grain_load load;               /* on ball 1, and the torque on ball 2 */
  carom_heats heats = {0.0, 0.0, 0.0}; /* each step adds to it */
  carom_error error;
  double before, energy = 0.0, elastic, imbalance = 0.0, sliding_before;
  int steps = 0;

  if (carom_law_make(&glass, &glass, friction, NULL, &law, &error) != CAROM_STATUS_OK) {
    printf("%s\n", error.text);
    failures += 1;
    return 0.0;
  }
  touch = calloc(1, carom_touch_size(law));
  start(&one, &two);
  before = kinetic(&one, mass, inertia) + kinetic(&two, mass, inertia);
  sliding_before = sliding(&one, &two);
  do {
    /* The velocities are those half a step before the new positions. */
    add(one.place, dt, one.velocity);
    add(two.place, dt, two.velocity);
    if (carom_touch_step(law, touch, &one, &two, NULL, dt, &load, &heats, &error) !=
        CAROM_STATUS_OK) {
      printf("%s: %s\n", error.field, error.text);
      failures += 1;
      break;
    }

    /* To the time of the positions, for the balance of energy; then half a step ahead. */
    kick(&one, &two, &load, mass, inertia, 0.5 * dt);
    carom_touch_energy(law, touch, radius, radius, &elastic, NULL);
    energy = kinetic(&one, mass, inertia) + kinetic(&two, mass, inertia) + elastic + heats.friction;
    imbalance = fmax(imbalance, fabs(energy / before - 1.0));
    kick(&one, &two, &load, mass, inertia, 0.5 * dt);
    steps += 1;
  } while (dot(load.force, load.force) > 0.0 && steps < 10000);
  free(touch);
  carom_law_free(law);

  printf("%d steps of %.3g s\n", steps, dt);
  printf("energy before %.4e J, after %.4e J, friction heat %.4e J, off balance by %.1e\n", before,
         energy - heats.friction, heats.friction, imbalance);
  must(steps > 100 && steps < 10000, "the balls touch and separate");
  must(imbalance < 1e-3, "what the motion loses is heat or elastic energy");
  must(heats.friction > 0.0, "friction heats");
  return -sliding(&one, &two) / sliding_before;
}
/* ANCHOR_END: steps */

int main(void) {
  const double pi = 3.14159265358979323846;
  const double mass = density * 4.0 / 3.0 * pi * radius * radius * radius;
  const double inertia = 0.4 * mass * radius * radius;
  const carom_rebound rebound = exact(mass);
  const double R_x = step(mass, inertia, rebound.duration / 400.0);
  printf("R_x = %.4f stepped, %.4f exact\n", R_x, rebound.R_x);
  /* The exact impact neglects that the normal turns, by 7e-4 rad while the balls touch. */
  must(fabs(R_x - rebound.R_x) < 2e-3, "the stepped impact is the exact one");
  if (failures == 0) printf("all is well\n");
  return failures != 0;
}
