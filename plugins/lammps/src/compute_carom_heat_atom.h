// compute carom/heat/atom: the heat that the contacts of each grain made in the last step.
#ifndef CAROM_COMPUTE_HEAT_ATOM_H
#define CAROM_COMPUTE_HEAT_ATOM_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

class ComputeCaromHeatAtom : public Compute {
 public:
  ComputeCaromHeatAtom(LAMMPS *lmp, int narg, char **arg);
  void init() override;
  void compute_peratom() override;
  int pack_reverse_comm(int n, int first, double *buffer) override;
  void unpack_reverse_comm(int n, int *list, double *buffer) override;
  double memory_usage() override;

 private:
  double of_wall = 1.0;    // the share of a grain in the heat of its contact with a wall
  std::vector<double> heat;
};

}    // namespace LAMMPS_NS

#endif
