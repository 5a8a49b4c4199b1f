#include "pace.h"

#include "comm.h"
#include "error.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace LAMMPS_NS;

namespace carom {

void Pace::begins(const carom_grains &grains, const carom_grain &one, double mass_1, const carom_grain &two,
                  double mass_2, double dt)
{
  double square = 0.0, along = 0.0;
  for (int k = 0; k < 3; k++) {
    const double arm = two.place[k] - one.place[k];
    square += arm * arm;
    along += arm * (one.velocity[k] - two.velocity[k]);
  }
  if (square > 0.0) impact(grains, one.radius, two.radius, mass_1, mass_2, along / std::sqrt(square), dt);
}

void Pace::begins(const carom_grains &grains, const carom_grain &one, double mass, const carom_wall &wall, double dt)
{
  const double infinite = std::numeric_limits<double>::infinity();
  double velocity = 0.0;
  for (int k = 0; k < 3; k++) velocity += wall.normal[k] * (wall.velocity[k] - one.velocity[k]);
  impact(grains, one.radius, infinite, mass, infinite, velocity, dt);
}

void Pace::impact(const carom_grains &grains, double radius_1, double radius_2, double mass_1, double mass_2,
                  double velocity, double dt)
{
  if (has_told || !(velocity > 0.0) || !(dt > 0.0)) return;
  double time = 0.0;
  if (carom_grains_impact_time(&grains, radius_1, radius_2, mass_1, mass_2, velocity, &time, nullptr) ==
      CAROM_STATUS_OK)
    fewest = std::min(fewest, time / dt);
}

void Pace::tell(LAMMPS *lmp)
{
  if (has_told) return;
  double all = fewest;
  MPI_Allreduce(&fewest, &all, 1, MPI_DOUBLE, MPI_MIN, lmp->world);
  has_told = all < FEWEST;
  if (!has_told || lmp->comm->me != 0) return;
  char text[200];
  snprintf(text, sizeof text,
           "pair carom: the time step is too long: the shortest impact so far lasts %.2g steps, and should last %g at "
           "the least, 50 for accurate friction",
           all, FEWEST);
  lmp->error->warning(FLERR, text);
}

}    // namespace carom
