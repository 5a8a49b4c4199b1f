#include "limits.h"

#include "comm.h"
#include "error.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

namespace carom {

// The bits of the ratios, in the order of Limits::ratios_of.
static constexpr uint32_t BITS[] = {CAROM_WARNING_TIME_STEP, CAROM_WARNING_LARGE_CONTACT,
                                    CAROM_WARNING_LARGE_APPROACH, CAROM_WARNING_YIELDS,
                                    CAROM_WARNING_WAVE_LOSS};

Limits::Ratios Limits::ratios_of(const carom_validity &validity)
{
  return {validity.step_over_duration, validity.semi_axis_over_radius, validity.approach_over_radius,
          validity.pressure_over_yield, validity.wave_share};
}

carom_validity Limits::validity_of(const Ratios &ratios)
{
  carom_validity validity = {};
  validity.step_over_duration = ratios[0];
  validity.semi_axis_over_radius = ratios[1];
  validity.approach_over_radius = ratios[2];
  validity.pressure_over_yield = ratios[3];
  validity.wave_share = ratios[4];
  return validity;
}

void Limits::add(const carom_validity &validity)
{
  const Ratios ratios = ratios_of(validity);
  for (int k = 0; k < RATIOS; k++) worst[k] = std::max(worst[k], ratios[k]);
}

void Limits::begins(const carom_law *law, const carom_grain &one, double mass_1, const carom_grain &two,
                    double mass_2, double dt)
{
  double square = 0.0, along = 0.0;
  for (int k = 0; k < 3; k++) {
    const double arm = two.place[k] - one.place[k];
    square += arm * arm;
    along += arm * (one.velocity[k] - two.velocity[k]);
  }
  if (square > 0.0) impact(law, one.radius, two.radius, mass_1, mass_2, along / std::sqrt(square), dt);
}

void Limits::begins(const carom_law *law, const carom_grain &one, double mass, const carom_surface &wall,
                    double dt)
{
  const double infinite = std::numeric_limits<double>::infinity();
  double velocity = 0.0;
  for (int k = 0; k < 3; k++) velocity += wall.normal[k] * (wall.velocity[k] - one.velocity[k]);
  impact(law, one.radius, infinite, mass, infinite, velocity, dt);
}

void Limits::impact(const carom_law *law, double radius_1, double radius_2, double mass_1, double mass_2,
                    double velocity, double dt)
{
  if (!(velocity > 0.0)) return;
  carom_validity validity;
  if (carom_law_impact_validity(law, radius_1, radius_2, mass_1, mass_2, velocity, dt, &validity, nullptr) ==
      CAROM_STATUS_OK)
    add(validity);
}

void Limits::look(const carom_encounter *contacts, int count)
{
  carom_validity validity;
  if (carom_encounters_validity(contacts, count, &validity, nullptr) == CAROM_STATUS_OK) add(validity);
}

void Limits::look(const carom_law *law, double radius, double overlap)
{
  const double infinite = std::numeric_limits<double>::infinity();
  carom_validity validity;
  if (overlap > 0.0 &&
      carom_law_validity(law, radius, infinite, overlap, &validity, nullptr) == CAROM_STATUS_OK)
    add(validity);
}

void Limits::tell(LAMMPS *lmp, const std::vector<Of> &styles, bool is_end)
{
  std::vector<double> mine, all(RATIOS * styles.size());
  for (const Of &style : styles) mine.insert(mine.end(), style.limits->worst.begin(), style.limits->worst.end());
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MAX, lmp->world);
  Ratios ratios = {};
  std::array<std::size_t, RATIOS> where = {};
  for (std::size_t at = 0; at < all.size(); at++) {
    const std::size_t k = at % RATIOS;
    if (all[at] <= ratios[k]) continue;
    ratios[k] = all[at];
    where[k] = at / RATIOS;
  }
  const carom_validity validity = validity_of(ratios);
  Ratios &told = styles.front().limits->told;
  for (int k = 0; k < RATIOS; k++) {
    const bool is_due = is_end ? ratios[k] > 2.0 * told[k] : told[k] == 0.0;
    char text[200];
    if (!is_due || carom_validity_text(&validity, BITS[k], text, sizeof text, nullptr) != CAROM_STATUS_OK ||
        text[0] == '\0')
      continue;
    told[k] = ratios[k];
    if (lmp->comm->me == 0) lmp->error->warning(FLERR, styles[where[k]].who + ": " + text);
  }
}

}    // namespace carom
