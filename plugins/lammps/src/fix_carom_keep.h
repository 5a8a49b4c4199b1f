// The pair style's own fix: contacts become numbers before the host moves grains or writes a restart
// file, and the account of heat goes into it.
#ifndef CAROM_FIX_KEEP_H
#define CAROM_FIX_KEEP_H

#include "fix.h"

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
  void serve(PairCarom *its);

 private:
  friend class PairCarom;
  PairCarom *pair = nullptr;
  double heats_of_file[2] = {0.0, 0.0};
};

}    // namespace LAMMPS_NS

#endif
