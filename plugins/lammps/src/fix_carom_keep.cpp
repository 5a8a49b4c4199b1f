#include "fix_carom_keep.h"

#include "pair_carom.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "neigh_list.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

FixCaromKeep::FixCaromKeep(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  restart_global = 1;
}

FixCaromKeep::~FixCaromKeep()
{
  if (pair) pair->keep = nullptr;
}

void FixCaromKeep::serve(PairCarom *its, NeighHistory *history_of_host)
{
  pair = its;
  history = history_of_host;
  pair->heats = {heats_of_file[0], heats_of_file[1]};
}

int FixCaromKeep::setmask()
{
  return FixConst::PRE_EXCHANGE | FixConst::MIN_PRE_EXCHANGE;
}

void FixCaromKeep::pre_exchange()
{
  if (!pair) return;
  pair->pack_all();
  pair->tell_of_limits(false);
}

void FixCaromKeep::post_run()
{
  if (!pair) return;
  pair->pack_all();
  pair->tell_of_limits(true);
}

void FixCaromKeep::min_pre_exchange()
{
  if (pair) pair->pack_all();
}

void FixCaromKeep::write_restart(FILE *fp)
{
  if (!pair) return;
  if (update->whichflag == 0) save();
  else pair->pack_all();
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
  if (!std::isfinite(all[0]) || !std::isfinite(all[1]))
    error->all(FLERR, "pair carom: the restart file is damaged: the heats are not finite numbers");
  heats_of_file[0] = comm->me == 0 ? all[0] : 0.0;
  heats_of_file[1] = comm->me == 0 ? all[1] : 0.0;
}

// Between runs the host has moved grains, with their contacts, since it built the neighbor list; yet its fix
// NEIGH_HISTORY collects contacts from that list once more when it writes its part. Therefore its contents
// are saved here and the list is emptied; FixCaromRestore puts them back.
void FixCaromKeep::save()
{
  known.clear();
  for (int i = 0; i < atom->nlocal; i++) {
    const std::size_t at = known.size();
    known.resize(at + history->size_restart(i));
    known.resize(at + history->pack_exchange(i, &known[at]));
  }
  if (pair->list) pair->list->inum = 0;
  history->nlocal_neigh = atom->nlocal;
  history->nall_neigh = atom->nlocal + atom->nghost;
}

void FixCaromKeep::restore()
{
  double *from = known.data();
  for (int i = 0; i < atom->nlocal && !known.empty(); i++) from += history->unpack_exchange(i, from);
  known.clear();
}

int FixCaromKeep::most_numbers() const
{
  int most = 0;
  for (int i = 0; i < atom->nlocal; i++) most = std::max(most, history->size_restart(i));
  return most;
}

FixCaromRestore::FixCaromRestore(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  restart_global = 1;
  maxexchange_dynamic = 1;
}

int FixCaromRestore::setmask()
{
  return FixConst::PRE_EXCHANGE | FixConst::MIN_PRE_EXCHANGE;
}

void FixCaromRestore::make_room()
{
  if (!keep) return;
  const int mine = keep->most_numbers();
  int most = 0;
  MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, world);
  // For a move of grains to any rank the host takes the largest size over all fixes, not their sum.
  for (const Fix *fix : modify->get_fix_list())
    if (fix != this) most += fix->maxexchange;
  maxexchange = most;
}

void FixCaromRestore::write_restart(FILE *fp)
{
  if (keep) keep->restore();
  if (comm->me != 0) return;
  const int size = 0;
  fwrite(&size, sizeof size, 1, fp);
}
