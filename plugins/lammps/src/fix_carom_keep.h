// The pair style's own fixes, one before and one after the host's NEIGH_HISTORY. Before the host moves grains
// or writes a restart file, they convert contacts to numbers and store the heats. They tell the host the
// largest number of contacts of a grain on any rank; the host itself would look on each rank alone, and not
// before the first step.
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
  void post_run() override;
  void min_pre_exchange() override;
  void write_restart(FILE *fp) override;
  void restart(char *buffer) override;

  // The pair style whose contacts it keeps; passes on what a restart file contained.
  void serve(PairCarom *its, NeighHistory *history);
  // Raises an error if a restart file has contacts of another size.
  void check_numbers(int numbers) const;
  // Restores the contents of the host's fix for each grain.
  void restore();
  // Largest number of values that the host's fix keeps for a grain of this rank.
  int most_numbers() const;

 private:
  friend class PairCarom;
  PairCarom *pair = nullptr;
  NeighHistory *history = nullptr;
  std::vector<double> known;
  void save();
  // What a restart file has: the size of a contact (0 without a file) and heats.
  static constexpr int KEPT = 4;
  double of_file[KEPT] = {0.0, 0.0, 0.0, 0.0};
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

  // Reserves space in the host's buffers for any grain with all its contacts, the same on all ranks.
  void make_room();

  FixCaromKeep *keep = nullptr;
};

}    // namespace LAMMPS_NS

#endif
