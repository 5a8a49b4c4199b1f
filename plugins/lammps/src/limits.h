// What the contacts of a run exceed of the theory: their size, yield, elastic waves, and whether the time step
// resolves the impacts. The library knows the limits and the words.
#ifndef CAROM_LIMITS_H
#define CAROM_LIMITS_H

#include "carom.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace carom {

// The worst of the contacts of one style on this rank. Contacts that begin are judged by their velocity, all
// others now and then by their overlap, which costs a contact step nothing that can be measured.
class Limits {
 public:
  // A run begins.
  void start() { *this = {}; }
  // Whether contacts are looked at in this step.
  static bool looks(int64_t step) { return step % EVERY == 0; }
  // A contact of two grains begins; a velocity of approach that is not positive says nothing.
  void begins(const carom_law *law, const carom_grain &one, double mass_1, const carom_grain &two,
              double mass_2, double dt);
  // A contact of a grain and a wall begins.
  void begins(const carom_law *law, const carom_grain &one, double mass, const carom_surface &wall, double dt);
  // Looks at contacts of grains, and at one with a wall.
  void look(const carom_encounter *contacts, int count);
  void look(const carom_law *law, double radius, double overlap);

  // The limits of a style, and its name in the log.
  struct Of {
    std::string who;
    Limits *limits;
  };
  // Logs each limit that is exceeded on any rank, with the worst style, once in a run; at its end once more if it
  // is exceeded twice as far as was told. All ranks call it, with the same styles; the first remembers what was
  // told.
  static void tell(LAMMPS_NS::LAMMPS *lmp, const std::vector<Of> &styles, bool is_end);

 private:
  // Contacts are looked at in one of so many steps: an impact should last 20 and more.
  static constexpr int EVERY = 10;
  static constexpr int RATIOS = 5;
  using Ratios = std::array<double, RATIOS>;

  Ratios worst = {};
  Ratios told = {};    // those that the log has

  static Ratios ratios_of(const carom_validity &validity);
  static carom_validity validity_of(const Ratios &ratios);
  void add(const carom_validity &validity);
  void impact(const carom_law *law, double radius_1, double radius_2, double mass_1, double mass_2,
              double velocity, double dt);
};

}    // namespace carom

#endif
