// compute carom/energy: the energies of all contacts of pair carom and of its walls.
#ifndef CAROM_COMPUTE_ENERGY_H
#define CAROM_COMPUTE_ENERGY_H

#include "compute.h"

namespace LAMMPS_NS {

class ComputeCaromEnergy : public Compute {
 public:
  ComputeCaromEnergy(LAMMPS *lmp, int narg, char **arg);
  ~ComputeCaromEnergy() override;
  void init() override;
  void compute_vector() override;
};

}    // namespace LAMMPS_NS

#endif
