// The carom walls of a run.
#ifndef CAROM_FIND_WALL_H
#define CAROM_FIND_WALL_H

#include "fix_wall_carom.h"

#include "modify.h"

#include <vector>

namespace carom {

inline std::vector<LAMMPS_NS::FixWallCarom *> find_walls(LAMMPS_NS::Modify *modify)
{
  std::vector<LAMMPS_NS::FixWallCarom *> found;
  for (LAMMPS_NS::Fix *fix : modify->get_fix_by_style("^wall/carom$"))
    if (auto *wall = dynamic_cast<LAMMPS_NS::FixWallCarom *>(fix)) found.push_back(wall);
  return found;
}

}    // namespace carom

#endif
