#include "fix_carom_keep.h"

#include "pair_carom.h"

#include "comm.h"

using namespace LAMMPS_NS;

FixCaromKeep::FixCaromKeep(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  restart_global = 1;
}

FixCaromKeep::~FixCaromKeep()
{
  if (pair) pair->keep = nullptr;
}

void FixCaromKeep::serve(PairCarom *its)
{
  pair = its;
  pair->heats = {heats_of_file[0], heats_of_file[1]};
}

int FixCaromKeep::setmask()
{
  return FixConst::PRE_EXCHANGE | FixConst::MIN_PRE_EXCHANGE;
}

void FixCaromKeep::pre_exchange()
{
  if (pair) pair->pack_all();
}

void FixCaromKeep::write_restart(FILE *fp)
{
  if (!pair) return;
  pair->pack_all();
  const double mine[2] = {pair->heats.friction, pair->heats.damping};
  double all[2];
  MPI_Reduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  const int size = sizeof all;
  fwrite(&size, sizeof size, 1, fp);
  fwrite(all, sizeof(double), 2, fp);
}

void FixCaromKeep::restart(char *buffer)
{
  const double *all = reinterpret_cast<double *>(buffer);
  heats_of_file[0] = comm->me == 0 ? all[0] : 0.0;
  heats_of_file[1] = comm->me == 0 ? all[1] : 0.0;
}
