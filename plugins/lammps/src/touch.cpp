#include "touch.h"

namespace carom {

carom_status Touch::step(const Constants &constants, const carom_grain &one, const carom_grain &two, double dt,
                         carom_grain_load *load, carom_heats *heats, carom_error *why) const
{
  const carom_grains *grains = &constants.grains;
  if (rings)
    return carom_ring_touch_grains(grains, constants.rings.get(), rings, &one, &two, dt, load, heats, why);
  return carom_touch_grains(grains, plain, &one, &two, dt, load, heats, why);
}

carom_status Touch::step(const Constants &constants, const carom_grain &one, const carom_surface &wall, double dt,
                         carom_grain_load *load, carom_heats *heats, carom_error *why) const
{
  const carom_grains *grains = &constants.grains;
  if (rings)
    return carom_ring_touch_surface(grains, constants.rings.get(), rings, &one, &wall, dt, load, heats, why);
  return carom_touch_surface(grains, plain, &one, &wall, dt, load, heats, why);
}

carom_status Touch::load(const Constants &constants, const carom_grain &one, const carom_grain &two,
                         carom_grain_load *load, carom_error *why) const
{
  const carom_grains *grains = &constants.grains;
  if (rings) return carom_ring_touch_grains_load(grains, constants.rings.get(), rings, &one, &two, load, why);
  return carom_touch_grains_load(grains, plain, &one, &two, load, why);
}

carom_status Touch::load(const Constants &constants, const carom_grain &one, const carom_surface &wall,
                         carom_grain_load *load, carom_error *why) const
{
  const carom_grains *grains = &constants.grains;
  if (rings) return carom_ring_touch_surface_load(grains, constants.rings.get(), rings, &one, &wall, load, why);
  return carom_touch_surface_load(grains, plain, &one, &wall, load, why);
}

double Touch::energy(const Constants &constants, double radius_1, double radius_2) const
{
  double energy = 0.0;
  if (rings)
    carom_ring_touch_energy(&constants.grains, constants.rings.get(), rings, radius_1, radius_2, &energy, nullptr);
  else
    carom_touch_energy(plain, &energy, nullptr);
  return energy;
}

carom_status Touch::report(const Constants &constants, carom_report *report, carom_error *why) const
{
  if (rings) return carom_ring_touch_report(constants.rings.get(), rings, report, why);
  return carom_touch_report(plain, report, why);
}

}    // namespace carom
