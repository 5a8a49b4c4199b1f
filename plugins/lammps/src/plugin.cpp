// Registers the styles with the host.

#include "compute_carom_energy.h"
#include "compute_carom_heat_atom.h"
#include "fix_carom_keep.h"
#include "fix_wall_carom.h"
#include "host.h"
#include "pair_carom.h"

#include "lammps.h"

#include <cstdio>
#include <cstring>

#ifndef CAROM_HOST_GIT
#error "CAROM_HOST_GIT and CAROM_HOST_VERSION tell for which LAMMPS this is built: see build.sh"
#endif
#ifndef CAROM_CPU
#error "CAROM_CPU tells for which processors the library was built: see build.sh"
#endif

using namespace LAMMPS_NS;

// Whether this processor has the instructions for which the library was built.
static bool runs_here()
{
#ifdef __x86_64__
  if (strcmp(CAROM_CPU, "x86-64-v3") == 0)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
#endif
  return true;
}

template <class Style> static void *of_one(void *lmp)
{
  return static_cast<void *>(static_cast<Pair *>(new Style(static_cast<LAMMPS *>(lmp))));
}

template <class Style, class Base> static void *of_arguments(void *lmp, int narg, char **arg)
{
  return static_cast<void *>(static_cast<Base *>(new Style(static_cast<LAMMPS *>(lmp), narg, arg)));
}

extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void *lmp, void *handle,
                                                                         void *registers)
{
  // Its classes change between updates of one release, so that the date alone does not identify them.
  if (strcmp(LAMMPS::git_descriptor(), CAROM_HOST_GIT) != 0) {
    fprintf(stderr, "carom: not loaded: built for LAMMPS %s, this is %s\n", CAROM_HOST_GIT,
            LAMMPS::git_descriptor());
    return;
  }
  if (!runs_here()) {
    fprintf(stderr, "carom: not loaded: built for processors with AVX2, and this has none: build it with "
                    "CAROM_CPU=generic\n");
    return;
  }
  if (carom_abi_version() != CAROM_ABI_VERSION) {
    fprintf(stderr, "carom: not loaded: carom.h and the library are of different versions\n");
    return;
  }
  const auto add = reinterpret_cast<carom_register>(registers);
  carom_plugin plugin;
  plugin.version = CAROM_HOST_VERSION;
  plugin.author = "the carom authors";
  plugin.handle = handle;

  plugin.style = "pair";
  plugin.name = "carom";
  plugin.info = "pair carom: elastic contact with friction and memory";
  plugin.creator.of_one = &of_one<PairCarom>;
  add(&plugin, lmp);

  plugin.style = "fix";
  plugin.name = "CAROM_KEEP";
  plugin.info = "what pair carom keeps";
  plugin.creator.of_arguments = &of_arguments<FixCaromKeep, Fix>;
  add(&plugin, lmp);

  plugin.name = "CAROM_RESTORE";
  plugin.creator.of_arguments = &of_arguments<FixCaromRestore, Fix>;
  add(&plugin, lmp);

  plugin.name = "wall/carom";
  plugin.info = "fix wall/carom: walls with the law of pair carom";
  plugin.creator.of_arguments = &of_arguments<FixWallCarom, Fix>;
  add(&plugin, lmp);

  plugin.style = "compute";
  plugin.name = "carom/energy";
  plugin.info = "compute carom/energy: stored energy, heats and work";
  plugin.creator.of_arguments = &of_arguments<ComputeCaromEnergy, Compute>;
  add(&plugin, lmp);

  plugin.name = "carom/heat/atom";
  plugin.info = "compute carom/heat/atom: heat that the contacts of each grain made in the last step";
  plugin.creator.of_arguments = &of_arguments<ComputeCaromHeatAtom, Compute>;
  add(&plugin, lmp);
}
