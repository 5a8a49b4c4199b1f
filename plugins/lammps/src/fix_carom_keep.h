// The pair style's own fixes, one before and one after the host's NEIGH_HISTORY. Contacts become numbers
// before the host moves grains or writes a restart file, and the account of heat goes into it. The host then
// has room for the grain with most contacts on any rank, which it would look for on each rank alone, and
// not at all before the first step.
#ifndef CAROM_FIX_KEEP_H
#define CAROM_FIX_KEEP_H

#include "host.h"

#include <vector>

namespace LAMMPS_NS {

class PairCarom;

class FixCaromKeep : public Fix {
 public:
  FixCaromKeep(LAMMPS *lmp, int narg, char **arg);
  ~FixCaromKeep() override;
  int setmask() override;
  void pre_exchange() override;
  void min_pre_exchange() override { pre_exchange(); }
  void post_run() override { pre_exchange(); }
  void write_restart(FILE *fp) override;
  void restart(char *buffer) override;

  // Whose contacts it keeps; hands over what a restart file told.
  void serve(PairCarom *its, NeighHistory *history);
  // What the host's fix knew of each grain, back into it.
  void restore();
  // The most numbers that the host's fix keeps of a grain of this rank.
  int most_numbers() const;

 private:
  friend class PairCarom;
  PairCarom *pair = nullptr;
  NeighHistory *history = nullptr;
  std::vector<double> known;
  void save();
  double heats_of_file[2] = {0.0, 0.0};
};

class FixCaromRestore : public Fix {
 public:
  FixCaromRestore(LAMMPS *lmp, int narg, char **arg);
  int setmask() override;
  void setup_pre_exchange() override { make_room(); }
  void pre_exchange() override { make_room(); }
  void min_pre_exchange() override { make_room(); }
  void post_run() override { make_room(); }
  void write_restart(FILE *fp) override;

  // Room in the host's buffers for any grain with all its contacts, on all ranks the same.
  void make_room();

  FixCaromKeep *keep = nullptr;
};

}    // namespace LAMMPS_NS

#endif
