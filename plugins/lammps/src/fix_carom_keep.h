// The pair style's own fixes, one before and one after the host's NEIGH_HISTORY. Contacts become numbers
// before the host moves grains or writes a restart file, and the account of heat goes into it.
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
  int setmask() override { return 0; }
  void write_restart(FILE *fp) override;

  FixCaromKeep *keep = nullptr;
};

}    // namespace LAMMPS_NS

#endif
