// The mass that a contact moves: that of a grain, or of the rigid body to which it belongs.
#ifndef CAROM_MASSES_H
#define CAROM_MASSES_H

#include "atom.h"
#include "fix.h"
#include "modify.h"

#include <vector>

namespace carom {

class Masses {
 public:
  // A run begins: finds the fixes of rigid bodies.
  void start(LAMMPS_NS::Modify *modify)
  {
    bodies = modify->get_fix_by_style("^rigid");
    is_known_ = false;
  }

  bool has_bodies() const { return !bodies.empty(); }
  // On all ranks alike, those without grains too.
  bool is_known() const { return is_known_; }

  // Those of all own grains, after grains moved between ranks. The host then copies them to ghosts.
  void refresh(const LAMMPS_NS::Atom *atom)
  {
    of_grains.assign(atom->rmass, atom->rmass + atom->nlocal);
    int dim;
    for (LAMMPS_NS::Fix *fix : bodies) {
      const auto *body_of = static_cast<const int *>(fix->extract("body", dim));
      const auto *total = static_cast<const double *>(fix->extract("masstotal", dim));
      if (!body_of || !total) continue;
      for (int i = 0; i < atom->nlocal; i++)
        if (body_of[i] >= 0) of_grains[i] = total[body_of[i]];
    }
    of_grains.resize(atom->nlocal + atom->nghost);
    is_known_ = true;
  }

  int pack(int n, const int *list, double *buffer) const
  {
    for (int k = 0; k < n; k++) buffer[k] = of_grains[list[k]];
    return n;
  }

  void unpack(int n, int first, const double *buffer)
  {
    for (int k = 0; k < n; k++) of_grains[first + k] = buffer[k];
  }

  // Of own grains and ghosts.
  const double *all(const LAMMPS_NS::Atom *atom) const { return has_bodies() ? of_grains.data() : atom->rmass; }

 private:
  std::vector<LAMMPS_NS::Fix *> bodies;
  std::vector<double> of_grains;
  bool is_known_ = false;
};

}    // namespace carom

#endif
