#include "compute_carom_heat_atom.h"

#include "find_pair.h"
#include "find_wall.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "update.h"
#include "utils.h"

#include <cstring>
#include <string>

using namespace LAMMPS_NS;

ComputeCaromHeatAtom::ComputeCaromHeatAtom(LAMMPS *lmp, int narg, char **arg) : Compute(lmp, narg, arg)
{
  for (int k = 3; k < narg; k += 2) {
    if (strcmp(arg[k], "wall") != 0 || k + 1 == narg)
      error->all(FLERR, std::string("compute carom/heat/atom does not know '") + arg[k] + "': only wall (with a value)");
    of_wall = utils::numeric(FLERR, arg[k + 1], false, lmp);
    if (!(of_wall >= 0.0 && of_wall <= 1.0))
      error->all(FLERR, std::string("compute carom/heat/atom: wall = ") + arg[k + 1] +
                            " is out of range: must be in [0, 1]");
  }
  peratom_flag = 1;
  size_peratom_cols = 0;
  comm_reverse = 1;
}

void ComputeCaromHeatAtom::init()
{
  const auto pairs = carom::find_pairs(force);
  if (pairs.empty()) error->all(FLERR, "compute carom/heat/atom requires pair_style carom");
  for (PairCarom *pair : pairs) {
    if (!pair->keeps_account())
      error->all(FLERR, "compute carom/heat/atom requires pair_style carom with energy yes");
    pair->heat_readers.add(this);
  }
}

void ComputeCaromHeatAtom::compute_peratom()
{
  invoked_peratom = update->ntimestep;
  const int count = atom->nlocal + (force->newton_pair ? atom->nghost : 0);
  heat.assign(atom->nmax, 0.0);
  vector_atom = heat.data();
  for (const PairCarom *pair : carom::find_pairs(force))
    for (int i = 0; i < count; i++) heat[i] += pair->grain_heat.of(i);
  for (const FixWallCarom *wall : carom::find_walls(modify))
    for (int i = 0; i < atom->nlocal; i++) heat[i] += of_wall * wall->grain_heat.of(i);
  if (force->newton_pair) comm->reverse_comm(this);
  for (int i = 0; i < atom->nlocal; i++)
    if (!(atom->mask[i] & groupbit)) heat[i] = 0.0;
}

int ComputeCaromHeatAtom::pack_reverse_comm(int n, int first, double *buffer)
{
  for (int k = 0; k < n; k++) buffer[k] = heat[first + k];
  return n;
}

void ComputeCaromHeatAtom::unpack_reverse_comm(int n, int *list, double *buffer)
{
  for (int k = 0; k < n; k++) heat[list[k]] += buffer[k];
}

double ComputeCaromHeatAtom::memory_usage()
{
  return static_cast<double>(heat.capacity() * sizeof(double));
}
