// Declarations that the host's installed headers lack: the interface of plugins, and the first data members
// of its fix NEIGH_HISTORY. Both are those of the release with which the plugin was built; lammpsplugin_init
// rejects any other release.
#ifndef CAROM_HOST_H
#define CAROM_HOST_H

#include "fix.h"

extern "C" {
typedef void *(carom_creator_1)(void *);
typedef void *(carom_creator_2)(void *, int, char **);
struct carom_plugin {
  const char *version, *style, *name, *info, *author;
  union {
    carom_creator_1 *of_one;
    carom_creator_2 *of_arguments;
  } creator;
  void *handle;
};
typedef void (*carom_register)(carom_plugin *, void *);
}

namespace LAMMPS_NS {
class NeighHistory : public Fix {
 public:
  int nlocal_neigh, nall_neigh, use_bit_flag;
  int **firstflag;
  double **firstvalue;
  class Pair *pair;
  using Fix::Fix;
};
}    // namespace LAMMPS_NS

#endif
