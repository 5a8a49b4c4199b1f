// Whether the time step resolves the contacts: how many steps the shortest impact of a run lasts.
#ifndef CAROM_PACE_H
#define CAROM_PACE_H

#include "carom.h"

#include <limits>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace carom {

// Looks only at contacts that begin, until the log has told of a time step that is too long.
class Pace {
 public:
  // Fewer steps in an impact are told.
  static constexpr double FEWEST = 20.0;

  // A run begins.
  void start() { *this = {}; }
  // A contact of two grains begins; a velocity of approach that is not positive says nothing.
  void begins(const carom_grains &grains, const carom_grain &one, double mass_1, const carom_grain &two,
              double mass_2, double dt);
  // A contact of a grain and a wall begins.
  void begins(const carom_grains &grains, const carom_grain &one, double mass, const carom_wall &wall, double dt);
  // Logs, once in a run, how few steps the shortest impact lasts, if they are too few. All ranks call it.
  void tell(LAMMPS_NS::LAMMPS *lmp);

 private:
  void impact(const carom_grains &grains, double radius_1, double radius_2, double mass_1, double mass_2,
              double velocity, double dt);
  double fewest = std::numeric_limits<double>::infinity();    // steps in an impact, on this rank
  bool has_told = false;
};

}    // namespace carom

#endif
