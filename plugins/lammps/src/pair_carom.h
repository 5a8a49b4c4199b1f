// pair_style carom: Hertz's normal force and Coulomb's friction with memory between spheres.
#ifndef CAROM_PAIR_H
#define CAROM_PAIR_H

#include "pair.h"

#include "carom.h"
#include "grain_heat.h"
#include "limits.h"
#include "masses.h"
#include "material.h"
#include "touches.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class NeighHistory;
class FixCaromKeep;

class PairCarom : public Pair {
  using Touches = carom::Touches;

 public:
  PairCarom(LAMMPS *lmp);
  ~PairCarom() override;

  void settings(int narg, char **arg) override;
  void coeff(int narg, char **arg) override;
  void init_style() override;
  double init_one(int i, int j) override;
  void compute(int eflag, int vflag) override;
  double single(int i, int j, int itype, int jtype, double rsq, double, double,
                double &fforce) override;
  void transfer_history(double *source, double *target, int, int) override;
  void write_restart(FILE *fp) override;
  void read_restart(FILE *fp) override;
  void write_restart_settings(FILE *fp) override;
  void read_restart_settings(FILE *fp) override;
  double memory_usage() override;
  int pack_forward_comm(int n, int *list, double *buffer, int, int *) override { return masses.pack(n, list, buffer); }
  void unpack_forward_comm(int n, int first, double *buffer) override { masses.unpack(n, first, buffer); }

  // Converts all contacts of this rank to numbers, for the host to move.
  void pack_all();
  // The elastic energy of this rank's contacts.
  double stored_energy();
  // The material of a grain type, for walls.
  const carom::Material &material(int type) const { return coefficients[place(type, type)]; }
  const carom::Law &law() const { return law_; }
  bool keeps_account() const { return account; }
  // That of a grain, or of the rigid body to which it belongs.
  double mass_of(int i) const { return masses.all(atom)[i]; }

  FixCaromKeep *keep = nullptr;    // null once the host has deleted it
  carom_heats heats = {0.0, 0.0, 0.0};    // of this rank, since the beginning
  carom::GrainHeat grain_heat;     // of the last step
  carom::HeatReaders heat_readers;
  // Logs what the contacts of this style and of its walls exceed.
  void tell_of_limits(bool is_end);

 private:
  carom::Law law_;
  int account = 0;
  int space = 0;    // for the numbers of a contact of any law
  std::vector<carom::Material> coefficients;    // by two types
  std::vector<carom::MadeLaw> laws;             // by the types of body 1 and 2
  std::vector<char> told;                       // of which pairs of types the log tells of coupling
  std::vector<double> largest;                  // radius of a type
  NeighHistory *history = nullptr;
  class FixCaromRestore *restore = nullptr;
  std::string keep_id, history_id, restore_id;
  Touches touches;
  carom::Limits limits;    // of this run
  carom::Masses masses;
  carom_error why;

  friend class FixCaromKeep;
  // Number of values of a contact in the host's slots.
  int numbers() const { return space + (account ? Touches::HEATS : 0); }
  double *heats_of(double *slot) const { return slot + space; }
  double energy_of(const carom_touch *touch, int body_1, int body_2) const;
  int place(int i, int j) const;
  void allocate();
  bool has_told_of_spin = false;
  void tell_of_spin();
  void tell_of_loss(const std::string &who, int i, int j) const;
  void make_laws();
  void make_laws(int i, int j);
  void set_space();
  // The host's arrays of grains, in the layout of the library.
  struct Bodies {
    const double *x, *v, *w, *radius;
    const double *mass;    // null where no force depends on it
    const int *mask;
    int frozen;
    double *f, *torque;
    const int *type;
    int types;    // and one more
    std::size_t moved;    // those that get forces from here
    void set(carom_grain &grain, std::size_t i) const;
    void add(std::size_t i, const double *force_i, const double *torque_i) const;
  };
  Bodies bodies() const;
  int frozen = 0;    // the groups of fix freeze
  bool weighs = false;    // whether a restitution needs the masses
  bool conducts = false;    // whether contacts conduct heat
  void conduct(const carom_encounter &met, int one, int two, std::size_t moved);
  // A grain that does not move, as one of a great mass, so that two of them have a reduced mass.
  static constexpr double HEAVY = 1e12;
  carom_touch *touch_of(double *slot, int body_1, int body_2);
  const carom::MadeLaw &law_of(int body_1, int body_2) const;

  // Two grains in contact now or one step ago: the host's flag and its slot for them.
  struct Close {
    int *flag;
    double *slot;
    int bodies[2];    // body 1, body 2
    bool apart, i_is_1;
  };
  static constexpr int TOGETHER = 64;
  Close close[TOGETHER];
  carom_encounter encounters[TOGETHER] = {};
  static int one_of(const Close &pair) { return pair.bodies[0]; }
  static int two_of(const Close &pair) { return pair.bodies[1]; }
  // The grain of the host's list, and its neighbor.
  static int i_of(const Close &pair) { return pair.bodies[!pair.i_is_1]; }
  static int j_of(const Close &pair) { return pair.bodies[pair.i_is_1]; }
  void step_alone(const Close &pair, carom_encounter &met, double dt, bool steps);
  void book(const Close &pair, const carom_heats &made);
  void step_all(int count, int eflag, bool moves);
  void tally(const Close &pair, double energy, const double *force_1, double sign);
  void end(const Close &pair);
  double *find_slot(int i, int j) const;
  double share_of(int j) const;
};

}    // namespace LAMMPS_NS

#endif
