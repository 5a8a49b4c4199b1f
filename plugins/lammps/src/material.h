// Materials and laws as given in an input script.
#ifndef CAROM_MATERIAL_H
#define CAROM_MATERIAL_H

#include "carom.h"
#include "made_law.h"

#include <set>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace carom {

// The number at a place after the keyword arg[0], or an error that names the keyword.
double numeric(LAMMPS_NS::LAMMPS *lmp, const std::string &who, char **arg, int place);

// Keywords that were given: an error names one that is given twice.
class Given {
 public:
  void add(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const std::string &word);

 private:
  std::set<std::string> words;
};

// Whether the word after the keyword arg[0] is yes, on or true rather than no, off or false; an error names what it is.
int flag(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int narg, char **arg);

// young E poisson NU
// shear G poisson NU
// rigid, yield Y, friction F, static_friction F, slip_friction A B C, damping A, restitution E, rolling K C F, conductivity K;
// plain data, written to restart files unchanged.
struct Material {
  int is_set = 0;      // whether any keyword was given
  int has_body = 0;    // whether there are moduli, or rigid
  double young = 0.0, poisson = 0.0;
  double friction = -1.0;    // not given; a of slip_friction
  double static_friction = 0.0;    // that of friction
  double slip_b = 0.0, slip_c = 0.0;    // friction + slip_b exp(-slip_c v)
  double damping = 0.0;
  double restitution = 1.0;    // elastic
  double yield = 0.0;        // not known
  double conductivity = 0.0;    // no heat is conducted
  carom_rolling rolling = {0.0, 0.0, 0.0};    // none

  // Reads a keyword and its value; returns the number of words read, 0 for an unknown keyword.
  int take(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int narg, char **arg);
  // Whether the contents of a restart file are a valid material; which keywords were given does not matter
  // then.
  bool come_from_file();
  // Raises an error for values that are missing or out of range.
  void check(LAMMPS_NS::LAMMPS *lmp, const std::string &who) const;
  carom_material body() const { return {young, poisson, yield}; }
  bool rolls() const { return rolling.friction > 0.0; }
  bool slips() const { return slip_b != 0.0; }
  // Whether damping or restitution was given in this run.
  bool names_loss() const { return has_loss; }
  bool loses() const { return damping > 0.0 || restitution < 1.0; }

 private:
  double shear = 0.0;
  bool has_young = false, has_shear = false, has_poisson = false, has_friction = false, has_slip = false,
       is_rigid = false, has_loss = false;
  int take_slip_friction(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int narg, char **arg);
  int take_rolling(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int narg, char **arg);
};

// law fixed-direction | coulomb | rings, tolerance T, torsion yes | no
struct Law {
  uint32_t law = CAROM_LAW_FIXED_DIRECTION;
  int torsion = 0;    // whether a twist about the normal has its torque; of law rings it always has
  double tolerance = 0.0;

  int take(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int narg, char **arg);
  bool is_known() const { return law <= CAROM_LAW_RINGS; }
  bool by_rings() const { return law == CAROM_LAW_RINGS; }
  const char *name() const;
};

// The law of the contacts of two bodies; an error of the host says what is out of range.
MadeLaw make_law(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const carom_material &one, const carom_material &two,
                 const Material &pair, const Law &law);

// That of grains of one radius at a curved wall, from that at a flat one: the two curvatures of the wall are those along
// the axis of the contact and across it.
MadeLaw law_at_curved_wall(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const MadeLaw &flat, double radius,
                           const double *curvature);

// Logs how much the coupling of dissimilar materials may matter where the law neglects it.
void tell_of_coupling(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const MadeLaw &law);

// Raises an error unless grains have temperatures and heat flows, by fix property/atom of the host.
void need_temperatures(LAMMPS_NS::LAMMPS *lmp, const std::string &who);

// Raises an error of the host with the message of the library.
[[noreturn]] void fail(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const carom_error &error);

}    // namespace carom

#endif
