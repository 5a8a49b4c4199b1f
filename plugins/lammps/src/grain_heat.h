// The heat that contacts made in the last step, by grain.
#ifndef CAROM_GRAIN_HEAT_H
#define CAROM_GRAIN_HEAT_H

#include "compute.h"

#include <cstddef>
#include <vector>

namespace carom {

// The computes of a run that want it.
class HeatReaders {
 public:
  void clear() { all.clear(); }
  void add(LAMMPS_NS::Compute *reader) { all.push_back(reader); }
  bool are_some() const { return !all.empty(); }
  // A step begins. Some fixes of the host evaluate a compute only once, unless told that this is out of date.
  void expire() const
  {
    for (LAMMPS_NS::Compute *reader : all) reader->invoked_flag &= ~LAMMPS_NS::Compute::INVOKED_PERATOM;
  }

 private:
  std::vector<LAMMPS_NS::Compute *> all;
};

// Of one style on this rank; it costs nothing unless it is wanted.
class GrainHeat {
 public:
  // A step begins, for so many grains.
  void begin(const HeatReaders &readers, int count)
  {
    is_wanted_ = readers.are_some();
    if (is_wanted_) heat.assign(count, 0.0);
  }
  bool is_wanted() const { return is_wanted_; }
  void add(int i, double made) { heat[i] += made; }
  double of(int i) const { return static_cast<std::size_t>(i) < heat.size() ? heat[i] : 0.0; }

 private:
  bool is_wanted_ = false;
  std::vector<double> heat;
};

}    // namespace carom

#endif
