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
#include <cstring>
#include <string>

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
  if (comm->me == 0) pair->heats = {of_file[1], of_file[2], of_file[3]};
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
  const double mine[KEPT - 1] = {pair->heats.friction, pair->heats.damping, pair->heats.rolling};
  double all[KEPT] = {static_cast<double>(pair->numbers())};
  MPI_Reduce(mine, all + 1, KEPT - 1, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  const int size = sizeof all;
  fwrite(&size, sizeof size, 1, fp);
  fwrite(all, sizeof(double), KEPT, fp);
}

void FixCaromKeep::restart(char *buffer)
{
  memcpy(of_file, buffer, sizeof of_file);
  if (!std::all_of(of_file, of_file + KEPT, [](double number) { return std::isfinite(number); }))
    error->all(FLERR, "pair carom: the restart file is damaged: the heats are not finite numbers");
}

void FixCaromKeep::check_numbers(int numbers) const
{
  if (of_file[0] == 0.0 || of_file[0] == numbers) return;
  char text[32];
  snprintf(text, sizeof text, "%g", of_file[0]);
  error->all(FLERR, std::string("pair carom: the contacts of the restart file have ") + text +
                        " numbers, those of this run " + std::to_string(numbers) +
                        ": law rings, torsion, energy, rolling and slip_friction must be as in the run that wrote it");
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
