// fix wall/carom: a wall of one of a few shapes or of triangles, at rest, moving or turning, with the law of pair carom.
#ifndef CAROM_FIX_WALL_H
#define CAROM_FIX_WALL_H

#include "fix.h"

#include "carom.h"
#include "grain_heat.h"
#include "limits.h"
#include "material.h"
#include "touches.h"
#include "wall_contact.h"
#include "wall_shape.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class PairCarom;

class FixWallCarom : public Fix {
  using Contact = carom::WallContact;

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
    double friction, damping, work, rolling = 0.0, conducted = 0.0;
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
  bool has_temperature = false;
  double temperature = 0.0;    // of the wall
  carom::WallShape wall;
  std::vector<carom::MadeLaw> flat;    // by type of grain, without curvature; null if the type has no material
  // Those of a curved wall, by type, radius of the grain and the two curvatures.
  std::map<std::array<double, 4>, carom::MadeLaw> curved;
  bool account = false;
  Sums sums_ = {0.0, 0.0, 0.0};
  // On the wall after the last step; the torque about its centre.
  double force_on_wall[3] = {0.0, 0.0, 0.0}, torque_on_wall[3] = {0.0, 0.0, 0.0};
  // By grain; one stays where a contact was, for the next one. Only a mesh makes more than one.
  std::vector<std::vector<Contact>> contacts;
  // Of the grain in work: where the wall is near, and which of its contacts goes on there, -1 for none.
  carom::WallShape::Near nears[carom::WallShape::MOST];
  int contact_at[carom::WallShape::MOST];
  // What the wall got in this step.
  struct Reaction {
    double force[3] = {0.0, 0.0, 0.0}, torque[3] = {0.0, 0.0, 0.0};
  };

  const PairCarom *pair = nullptr;    // the first of the pair styles

  // The values of a pair style, but for those that were given to the wall.
  carom::Law law_with(carom::Law its) const;
  [[noreturn]] void damaged(const std::string &what) const;
  [[noreturn]] void refuse(int i, const carom::WallShape::Near &near) const;
  carom_touch *touch_of(int i, Contact &contact);
  void meet(int i, double duration, bool looks, Reaction &sum);
  void assign(int i, int count);
  void touch(int i, Contact &contact, carom::WallShape::Near &near, double duration, Reaction &sum);
  carom_grain_load step(int i, Contact &contact, carom::WallShape::Near &near, double duration);
  void begin_or_carry(Contact &contact, carom::WallShape::Near &near) const;
  const carom::MadeLaw &law_of(int i, const Contact &contact);
  const carom::MadeLaw &make_curved(int type, double radius, const double *curvature);
  double energy_of(int i, Contact &contact);
  void let_go(int i, Contact &contact);
  void book(int i, const carom_heats &made);
  void conduct(int i, const carom::WallShape::Near &near, double duration);
  void drop_all(int i);
  Contact &free_contact(int i);
  // Number of values that are kept of a contact behind its numbers: how the wall was where it began.
  int behind() const { return wall.is_curved() ? static_cast<int>(sizeof(Contact::Began) / sizeof(double)) : 0; }
  int most_contacts() const { return wall.is_mesh() ? carom::wall_numbers::MOST_CONTACTS : 1; }
};

}    // namespace LAMMPS_NS

#endif
