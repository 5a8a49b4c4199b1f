/* A ball on a plate, and R_x of many balls: carom from C.
 *
 *     cc impact.c $(pkg-config --cflags --libs carom) -lm -o impact
 *
 * Prints its results, and exits with 1 if one is wrong.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "carom.h"

static int failures = 0;

static void must(int holds, const char *what) {
  if (!holds) {
    printf("wrong: %s\n", what);
    failures += 1;
  }
}

/* ANCHOR: impact */
/* A steel ball that hits a plate obliquely. */
static void impact(void) {
  const carom_material steel = {208e9, 0.3, 0};
  carom_body ball = {0}, plate = {0};
  ball.shape = CAROM_SHAPE_SPHERE;
  ball.sizes[0] = 0.01;
  ball.mass = 0.0327;
  ball.material = steel;
  ball.velocity[0] = 0.5;
  ball.velocity[2] = -1.0;
  plate.shape = CAROM_SHAPE_PLANE;
  plate.material = steel;

  const double up[3] = {0.0, 0.0, 1.0};
  carom_rebound rebound;
  carom_error error;
  const carom_status status = carom_collide(&ball, &plate, 0.15, up, NULL, &rebound, &error);
  if (status != CAROM_STATUS_OK) {
    printf("%s: %s\n", carom_status_text(status), error.text);
    failures += 1;
    return;
  }
  printf("after: v = (%.6f, %.6f, %.6f) m/s, spin about y %.3f 1/s\n", rebound.body_1_velocity[0],
         rebound.body_1_velocity[1], rebound.body_1_velocity[2], rebound.body_1_spin[1]);
  printf("R_x = %.6f in %.1f us at up to %.0f N\n", rebound.R_x, 1e6 * rebound.duration,
         rebound.maximal_force);
  for (uint32_t bit = 1; bit != 0 && bit <= rebound.warnings; bit *= 2) {
    if (rebound.warnings & bit) printf("warning: %s\n", carom_warning_text(bit));
  }
  must(fabs(rebound.body_1_velocity[2] - 1.0) < 1e-12, "it rises as fast as it fell");
  const double balance = rebound.energy_before - rebound.energy_after - rebound.energy_dissipated;
  must(fabs(balance) < 1e-9 * rebound.energy_before, "friction takes the energy that is missing");

  /* The same with a coefficient of normal restitution of 0.9. */
  carom_collide_options options = {0};
  options.size = sizeof options;
  options.loss = CAROM_LOSS_GIVEN;
  options.normal_restitution = 0.9;
  must(carom_collide(&ball, &plate, 0.15, up, &options, &rebound, &error) == CAROM_STATUS_OK &&
           fabs(rebound.body_1_velocity[2] - 0.9) < 1e-12 && rebound.energy_lost > 0.0,
       "it rises slower");

  ball.mass = -1.0;
  must(carom_collide(&ball, &plate, 0.15, up, NULL, &rebound, &error) ==
               CAROM_STATUS_OUT_OF_RANGE &&
           strcmp(error.field, "mass") == 0 && error.value == -1.0,
       "a bad mass is named");
}
/* ANCHOR_END: impact */

/* R_x of many impacts by the table, compared with one exact impact. */
static void restitution(void) {
  const double kappa = 1.2142857142857142; /* nu = 0.3 */
  double lambda[100], table[100], exact;
  for (int i = 0; i < 100; ++i) lambda[i] = 0.08 * (i + 1);
  must(carom_restitution_many(100, &kappa, 0, lambda, sizeof(double), 1.0, CAROM_BY_TABLE, table,
                              sizeof(double), NULL) == CAROM_STATUS_OK,
       "R_x of many");
  for (int i = 0; i < 100; i += 11) {
    must(carom_restitution(kappa, lambda[i], 1.0, CAROM_EXACT, &exact, NULL) == CAROM_STATUS_OK,
         "R_x");
    must(fabs(table[i] - exact) < 1e-8, "the table is within 1e-8");
  }
  printf("R_x(1.214, 0.96) = %.8f\n", table[11]);
  /* A rigid sphere on one of nu = 0.3 with f = 0.1: coupling throws it back. */
  double estimate;
  uint32_t method;
  must(carom_restitution_dissimilar(kappa, 1.5 - kappa, 0.1, 2.0, 3.5, &exact, &estimate, &method,
                                    NULL) == CAROM_STATUS_OK &&
           method == CAROM_BY_TABLE && estimate < 0.02,
       "R_x of dissimilar spheres");
  printf("dissimilar: R_x(1.214, 2) = %.3f, within %.3f\n", exact, estimate);
}

/* ANCHOR: contacts */
/* Contacts of a particle code: stored inside the caller's own structures, one call for all. */
static void contacts(void) {
  struct particle {
    int id;
    carom_shift shift;
    carom_load load;
    carom_contact memory;
  } particles[8];
  memset(particles, 0, sizeof particles);

  const carom_material glass = {70e9, 0.22, 0};
  carom_pair pair;
  carom_error error;
  must(carom_pair_of_spheres(&glass, &glass, 1e-3, 1e-3, 0.4, CAROM_LAW_COULOMB, 0.0, &pair,
                             &error) == CAROM_STATUS_OK,
       "a pair");
  for (int step = 0; step < 250; ++step) {
    for (int i = 0; i < 8; ++i) {
      const double t = 0.01 * step;
      particles[i].shift.zeta = 1e-7 * sin(3.0 * t) * (1.0 + 0.1 * i) - 1e-8;
      particles[i].shift.xi = 3e-8 * sin(5.0 * t + i);
      particles[i].shift.eta = 3e-8 * cos(4.0 * t);
    }
    const size_t stride = sizeof(struct particle);
    must(carom_contact_advance_many(&pair, 8, &particles[0].memory, stride, &particles[0].shift,
                                    stride, &particles[0].load, stride, &error) == CAROM_STATUS_OK,
         "a step of all");
    for (int i = 0; i < 8; ++i) {
      const carom_load f = particles[i].load;
      must(hypot(f.f_x, f.f_y) <= 0.4 * f.f_z * (1.0 + 1e-12) + 1e-300, "Coulomb's limit");
    }
  }
  /* A restart: 66 numbers, which any build can read, give the same load. */
  carom_state numbers;
  carom_contact restarted;
  carom_load again;
  memset(&restarted, 0, sizeof restarted);
  must(carom_contact_pack(&pair, &particles[3].memory, &numbers, &error) == CAROM_STATUS_OK &&
           carom_contact_unpack(&pair, &numbers, &restarted, &error) == CAROM_STATUS_OK &&
           carom_contact_load(&pair, &restarted, &again, &error) == CAROM_STATUS_OK,
       "a restart");
  printf("contact 3: F = (%.6e, %.6e, %.6e) N\n", again.f_x, again.f_y, again.f_z);
  must(again.f_z > 0.0 && fabs(again.f_x - particles[3].load.f_x) <= 1e-12 * again.f_z,
       "the same load again");

  must(carom_contact_advance(&pair, NULL, particles[0].shift, NULL, &error) ==
           CAROM_STATUS_NULL_POINTER,
       "a null pointer is told");
}
/* ANCHOR_END: contacts */

/* ANCHOR: surface */
/* A ball over the ridge of a roof, which is a place of the wall of carom_touch_step. */
static void surface(void) {
  const double roof[2][3][3] = {{{0, 0, 1}, {0, 4, 1}, {-2, 2, 0}}, {{0, 0, 1}, {0, 4, 1}, {2, 2, 0}}};
  const double radius = 0.5, center[3] = {0, 2, 1.4};
  carom_mesh *mesh;
  carom_place places[4];
  size_t count;
  carom_error error;
  if (carom_mesh_make(&roof[0][0][0], 2, 0.2, NULL, &mesh, &error) != CAROM_STATUS_OK) {
    printf("%s\n", error.text);
    failures += 1;
    return;
  }
  must(carom_mesh_places(mesh, center, radius, places, 4, &count, &error) == CAROM_STATUS_OK &&
           count == 1 && places[0].part == CAROM_PART_EDGE && places[0].is_sharp &&
           places[0].normal[2] == 1.0 && fabs(places[0].distance - 0.4) < 1e-15,
       "the ball touches the ridge");
  carom_mesh_free(mesh);
}
/* ANCHOR_END: surface */

int main(void) {
  printf("carom %s\n", carom_version());
  must(carom_abi_version() == CAROM_ABI_VERSION, "header and library are of one version");
  impact();
  restitution();
  contacts();
  surface();
  printf(failures == 0 ? "all is well\n" : "failed\n");
  return failures == 0 ? 0 : 1;
}
