// The carom pair styles of a run: one, or several under pair_style hybrid.
#ifndef CAROM_FIND_PAIR_H
#define CAROM_FIND_PAIR_H

#include "pair_carom.h"

#include "force.h"

#include <vector>

namespace carom {

inline std::vector<LAMMPS_NS::PairCarom *> find_pairs(LAMMPS_NS::Force *force)
{
  std::vector<LAMMPS_NS::PairCarom *> found;
  for (int k = 1;; k++) {
    auto *pair = dynamic_cast<LAMMPS_NS::PairCarom *>(force->pair_match("carom", 1, k));
    // A pair style that is not a hybrid is found with any number.
    if (!pair || (!found.empty() && found.back() == pair)) return found;
    found.push_back(pair);
  }
}

}    // namespace carom

#endif
