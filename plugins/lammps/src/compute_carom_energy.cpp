#include "compute_carom_energy.h"

#include "find_pair.h"
#include "find_wall.h"

#include "error.h"
#include "force.h"
#include "modify.h"
#include "update.h"

using namespace LAMMPS_NS;

// c_ID[1] and so on.
enum { STORED, FRICTION, DAMPING, WORK_OF_WALLS, ROLLING, OUTPUTS };

ComputeCaromEnergy::ComputeCaromEnergy(LAMMPS *lmp, int narg, char **arg) : Compute(lmp, narg, arg)
{
  if (narg != 3) error->all(FLERR, "compute carom/energy takes no arguments");
  if (igroup != 0) error->all(FLERR, "compute carom/energy must use group all");
  vector_flag = 1;
  size_vector = OUTPUTS;
  extvector = 1;
  vector = new double[OUTPUTS]();
}

ComputeCaromEnergy::~ComputeCaromEnergy()
{
  delete[] vector;
}

void ComputeCaromEnergy::init()
{
  const auto pairs = carom::find_pairs(force);
  if (pairs.empty()) error->all(FLERR, "compute carom/energy requires pair_style carom");
  for (const PairCarom *pair : pairs)
    if (!pair->keeps_account())
      error->all(FLERR, "compute carom/energy requires pair_style carom with energy yes");
}

void ComputeCaromEnergy::compute_vector()
{
  invoked_vector = update->ntimestep;
  double mine[OUTPUTS] = {};
  for (PairCarom *pair : carom::find_pairs(force)) {
    mine[STORED] += pair->stored_energy();
    mine[FRICTION] += pair->heats.friction;
    mine[DAMPING] += pair->heats.damping;
    mine[ROLLING] += pair->heats.rolling;
  }
  for (FixWallCarom *wall : carom::find_walls(modify)) {
    mine[STORED] += wall->stored_energy();
    mine[FRICTION] += wall->sums().friction;
    mine[DAMPING] += wall->sums().damping;
    mine[ROLLING] += wall->sums().rolling;
    mine[WORK_OF_WALLS] += wall->sums().work;
  }
  MPI_Allreduce(mine, vector, OUTPUTS, MPI_DOUBLE, MPI_SUM, world);
}
