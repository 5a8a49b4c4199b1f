// fix wall/carom: a wall of one of a few shapes, at rest, moving or turning, with the law of pair carom.
#ifndef CAROM_FIX_WALL_H
#define CAROM_FIX_WALL_H

#include "fix.h"

#include "carom.h"
#include "grain_heat.h"
#include "limits.h"
#include "material.h"
#include "touches.h"
#include "wall_shape.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class PairCarom;

class FixWallCarom : public Fix {
  using Touches = carom::Touches;

 public:
  FixWallCarom(LAMMPS *lmp, int narg, char **arg);
  ~FixWallCarom() override;
  int setmask() override;
  void init() override;
  void setup(int vflag) override { post_force(vflag); }
  void post_force(int vflag) override;
  double compute_vector(int n) override;

  void write_restart(FILE *fp) override;
  void restart(char *buffer) override;
  void grow_arrays(int nmax) override;
  void copy_arrays(int i, int j, int delflag) override;
  void set_arrays(int i) override;
  int pack_exchange(int i, double *buffer) override;
  int unpack_exchange(int nlocal, double *buffer) override;
  int pack_restart(int i, double *buffer) override;
  void unpack_restart(int nlocal, int nth) override;
  int size_restart(int i) override;
  int maxsize_restart() override;
  double memory_usage() override;

  // Of this rank's contacts.
  double stored_energy();
  // Sums of this rank: heats, and the work that the moving wall did.
  struct Sums {
    double friction, damping, work, rolling = 0.0;
  };
  const Sums &sums() const { return sums_; }

  std::string who() const { return std::string("fix ") + id + " wall/carom"; }
  // Whether the wall takes its defaults from this pair style.
  bool is_of(const PairCarom *its) const { return pair == its; }
  carom::Limits limits;    // of this run
  carom::GrainHeat grain_heat;    // of the last step

 private:
  carom::Material material;
  carom::Law law;                       // those of its values that were given
  bool has_law = false, has_tolerance = false, has_torsion = false;
  bool has_told = false;    // of coupling, in the log
  carom::WallShape wall;
  std::vector<carom::Constants> flat;    // the constants by type of grain, without curvature
  // Those of a curved wall, by type, radius of the grain and curvature.
  std::map<std::pair<int, std::pair<double, double>>, carom::Constants> curved;
  std::vector<char> known;                // whether there are any
  bool account = false, twists = false;    // of the laws but rings
  Sums sums_ = {0.0, 0.0, 0.0};
  // On the wall after the last step; the torque about its centre.
  double force_on_wall[3] = {0.0, 0.0, 0.0}, torque_on_wall[3] = {0.0, 0.0, 0.0};
  Touches touches;
  std::vector<std::unique_ptr<double[]>> slots;    // by grain; null where nothing ever touched

  const PairCarom *pair = nullptr;    // the first of the pair styles

  // The values of a pair style, but for those that were given to the wall.
  carom::Law law_with(carom::Law its) const;
  [[noreturn]] void damaged(const std::string &what) const;
  carom::Touch touch_of(int i);
  carom_grain_load step(int i, const carom::WallShape::Near &near, double duration);
  void roll(int i, const carom_grain &grain, const carom_surface &surface, double duration, carom_grain_load &load);
  const carom::Constants &constants_of(int i);
  const carom::Constants &make_curved(int type, double radius, double curvature);
  double energy_of(int i);
  void let_go(int i);
  void book(int i, const carom::HeatSums &made);
  void pack(int i);
  void drop(int i);
  double *slot_of(int i);
  // A slot: the numbers of a contact of any law, then what only walls keep.
  static constexpr int SLOT = Touches::MOST + Touches::AT_WALL + Touches::FRICTION;
  static carom_roll *roll_of(double *slot) { return Touches::roll_at(slot + Touches::MOST); }
  static double &curvature_of(double *slot) { return slot[Touches::MOST + Touches::ROLL]; }
  double *friction_of(double *slot) const { return material.slips() ? slot + Touches::MOST + Touches::AT_WALL : nullptr; }
  // Number of values that are kept of a contact behind its numbers.
  int more() const
  {
    if (material.slips()) return Touches::AT_WALL + Touches::FRICTION;
    return material.rolls() || wall.is_curved() ? Touches::AT_WALL : 0;
  }
  int count_of(int i) const;
  bool touches_wall(int i) const { return slots[i] && slots[i][0] != 0.0; }
};

}    // namespace LAMMPS_NS

#endif
