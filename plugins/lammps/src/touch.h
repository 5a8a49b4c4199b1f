// The contact of two bodies with any law: the library has one type for the law of rings and one for the
// others.
#ifndef CAROM_TOUCH_H
#define CAROM_TOUCH_H

#include "carom.h"

#include <memory>

namespace carom {

// The constants of the contacts of two materials; copies share the matrices of the law of rings.
struct Constants {
  carom_grains grains = {};
  std::shared_ptr<const carom_rings> rings;    // null for the other laws
  carom_rolling rolling = {0.0, 0.0, 0.0};

  bool rolls() const { return rolling.friction > 0.0; }
};

// Heat by cause.
struct HeatSums {
  double friction = 0.0, damping = 0.0, rolling = 0.0;

  double all() const { return friction + damping + rolling; }
};

// An unpacked contact, of one of the two types.
struct Touch {
  carom_touch *plain = nullptr;
  carom_ring_touch *rings = nullptr;

  explicit operator bool() const { return plain || rings; }

  // A step of two grains, or of a grain and a wall of any shape.
  carom_status step(const Constants &constants, const carom_grain &one, const carom_grain &two, double dt,
                    carom_grain_load *load, carom_heats *heats, carom_error *why) const;
  carom_status step(const Constants &constants, const carom_grain &one, const carom_surface &wall, double dt,
                    carom_grain_load *load, carom_heats *heats, carom_error *why) const;
  // The load after the last step.
  carom_status load(const Constants &constants, const carom_grain &one, const carom_grain &two,
                    carom_grain_load *load, carom_error *why) const;
  carom_status load(const Constants &constants, const carom_grain &one, const carom_surface &wall,
                    carom_grain_load *load, carom_error *why) const;
  // The elastic energy, without the separate twist of laws other than rings.
  double energy(const Constants &constants, double radius_1, double radius_2) const;
  carom_status report(const Constants &constants, carom_report *report, carom_error *why) const;
};

}    // namespace carom

#endif
