// fix wall/carom: a wall of one of a few shapes or of triangles, at rest, moving or turning, with the law of pair carom.
#ifndef CAROM_FIX_WALL_H
#define CAROM_FIX_WALL_H

#include "fix.h"

#include "carom.h"
#include "grain_heat.h"
#include "limits.h"
#include "material.h"
#include "touches.h"
#include "wall_shape.h"

#include <array>
#include <map>
#include <memory>
#include <string>
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
  // Those of a curved wall, by type, radius of the grain and the two curvatures.
  std::map<std::array<double, 4>, carom::Constants> curved;
  std::vector<char> known;                // whether there are any
  bool account = false, twists = false;    // of the laws but rings
  Sums sums_ = {0.0, 0.0, 0.0};
  // On the wall after the last step; the torque about its centre.
  double force_on_wall[3] = {0.0, 0.0, 0.0}, torque_on_wall[3] = {0.0, 0.0, 0.0};
  Touches touches;
  // By grain; a slot stays where a contact was, for the next one. Only a mesh makes more than one.
  std::vector<std::vector<std::unique_ptr<double[]>>> slots;
  // Of the grain in work: where the wall is near, and which of its slots goes on there, -1 for none.
  carom::WallShape::Near nears[carom::WallShape::MOST];
  int slot_at[carom::WallShape::MOST];
  // What the wall got in this step.
  struct Reaction {
    double force[3] = {0.0, 0.0, 0.0}, torque[3] = {0.0, 0.0, 0.0};
  };

  const PairCarom *pair = nullptr;    // the first of the pair styles

  // The values of a pair style, but for those that were given to the wall.
  carom::Law law_with(carom::Law its) const;
  [[noreturn]] void damaged(const std::string &what) const;
  [[noreturn]] void refuse(int i, const carom::WallShape::Near &near) const;
  carom::Touch touch_of(int i, double *slot);
  void meet(int i, double duration, bool looks, Reaction &sum);
  void assign(int i, int count);
  void touch(int i, double *slot, carom::WallShape::Near &near, double duration, Reaction &sum);
  carom_grain_load step(int i, double *slot, carom::WallShape::Near &near, double duration);
  void begin_or_carry(double *slot, carom::WallShape::Near &near) const;
  void roll(int i, double *slot, const carom_grain &grain, const carom_surface &surface, double duration,
            carom_grain_load &load);
  const carom::Constants &constants_of(int i, double *slot);
  const carom::Constants &make_curved(int type, double radius, const double *curvature);
  double energy_of(int i, double *slot);
  void let_go(int i, double *slot);
  void book(int i, const carom::HeatSums &made);
  void drop(double *slot);
  void drop_all(int i);
  int free_slot(int i);
  double *new_slot(int i);
  // A slot: the numbers of a contact of any law, then what only walls keep.
  static constexpr int SLOT = Touches::MOST + Touches::AT_WALL + Touches::FRICTION;
  static carom_roll *roll_of(double *slot) { return Touches::roll_at(slot + Touches::MOST); }
  static Touches::Began &began_of(double *slot) { return *Touches::began_at(slot + Touches::MOST); }
  double *friction_of(double *slot) const { return material.slips() ? slot + Touches::MOST + Touches::AT_WALL : nullptr; }
  // Number of values that are kept of a contact behind its numbers.
  int more() const
  {
    if (material.slips()) return Touches::AT_WALL + Touches::FRICTION;
    return material.rolls() || wall.is_curved() ? Touches::AT_WALL : 0;
  }
  int count_of(double *slot) const;
  int most_contacts() const { return wall.is_mesh() ? Touches::MOST_AT_WALL : 1; }
  static bool is_in_use(const std::unique_ptr<double[]> &slot) { return slot[0] != 0.0; }
};

}    // namespace LAMMPS_NS

#endif
