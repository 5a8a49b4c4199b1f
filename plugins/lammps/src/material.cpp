#include "material.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "utils.h"

#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

namespace carom {

void fail(LAMMPS *lmp, const std::string &who, const carom_error &error)
{
  lmp->error->one(FLERR, who + ": " + error.text);
}

void need_temperatures(LAMMPS *lmp, const std::string &who)
{
  if (!lmp->atom->temperature_flag || !lmp->atom->heatflow_flag)
    lmp->error->all(FLERR, who + ": conductivity requires fix property/atom temperature heatflow ghost yes, and fix heat/flow");
}

static void out_of_range(LAMMPS *lmp, const std::string &who, const char *field, double value,
                         const char *allowed)
{
  char number[32];
  snprintf(number, sizeof number, "%g", value);
  lmp->error->all(FLERR,
                  who + ": " + field + " = " + number + " is out of range: must be " + allowed);
}

double numeric(LAMMPS *lmp, const std::string &who, char **arg, int place)
{
  if (!utils::is_double(arg[place]))
    lmp->error->all(FLERR, who + ": " + arg[0] + " takes numbers only, not '" + arg[place] + "'");
  return utils::numeric(FLERR, arg[place], false, lmp);
}

void Given::add(LAMMPS *lmp, const std::string &who, const std::string &word)
{
  if (!words.insert(word).second) lmp->error->all(FLERR, who + ": " + word + " is given twice");
}

static double number(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  if (narg < 2) lmp->error->all(FLERR, who + ": " + arg[0] + " requires a value");
  return numeric(lmp, who, arg, 1);
}

int flag(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  if (narg < 2) lmp->error->all(FLERR, who + ": " + arg[0] + " requires yes or no");
  const std::string given = arg[1];
  for (const char *yes : {"yes", "on", "true"})
    if (given == yes) return 1;
  for (const char *no : {"no", "off", "false"})
    if (given == no) return 0;
  lmp->error->all(FLERR, who + ": " + arg[0] + " takes yes or no, not '" + given + "'");
  return 0;
}

// rolling K C F: stiffness, damping and friction.
int Material::take_rolling(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  if (narg < 4) lmp->error->all(FLERR, who + ": rolling requires three values: stiffness, damping and friction");
  const auto value = [&](int k) { return numeric(lmp, who, arg, k); };
  rolling = {value(1), value(2), value(3)};
  if (!(rolling.stiffness > 0.0 && rolling.stiffness < INFINITY))
    out_of_range(lmp, who, "rolling: stiffness", rolling.stiffness, "finite and > 0");
  if (!(rolling.damping >= 0.0 && rolling.damping < INFINITY))
    out_of_range(lmp, who, "rolling: damping", rolling.damping, "finite and >= 0");
  if (!(rolling.friction >= 0.0 && rolling.friction < INFINITY))
    out_of_range(lmp, who, "rolling: friction", rolling.friction, "finite and >= 0");
  is_set = 1;
  return 4;
}

// slip_friction A B C: f = A + B exp(-C v).
int Material::take_slip_friction(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  if (narg < 4) lmp->error->all(FLERR, who + ": slip_friction requires three values: a, b and c");
  const auto value = [&](int k) { return numeric(lmp, who, arg, k); };
  friction = value(1), slip_b = value(2), slip_c = value(3);
  if (!(friction >= 0.0 && friction < INFINITY))
    out_of_range(lmp, who, "slip_friction: a", friction, "finite and >= 0");
  if (!(friction + slip_b >= 0.0 && friction + slip_b < INFINITY))
    out_of_range(lmp, who, "slip_friction: b", slip_b, "finite, with a + b >= 0");
  if (!(slip_c >= 0.0 && slip_c < INFINITY))
    out_of_range(lmp, who, "slip_friction: c", slip_c, "finite and >= 0");
  has_slip = true;
  is_set = 1;
  return 4;
}

int Material::take(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  const std::string word = arg[0];
  if (word == "rigid") {
    young = std::numeric_limits<double>::infinity();
    is_set = has_body = 1;
    is_rigid = true;
    return 1;
  }
  if (word == "rolling") return take_rolling(lmp, who, narg, arg);
  if (word == "slip_friction") return take_slip_friction(lmp, who, narg, arg);
  if (word == "young") {
    young = number(lmp, who, narg, arg);
    has_young = true;
  } else if (word == "shear") {
    shear = number(lmp, who, narg, arg);
    has_shear = true;
  } else if (word == "poisson") {
    poisson = number(lmp, who, narg, arg);
    has_poisson = true;
  } else if (word == "yield") {
    yield = number(lmp, who, narg, arg);
    if (!(yield > 0.0 && yield < INFINITY)) out_of_range(lmp, who, "yield", yield, "finite and > 0");
  } else if (word == "friction") {
    friction = number(lmp, who, narg, arg);
    if (!(friction >= 0.0 && friction < INFINITY))
      out_of_range(lmp, who, "friction", friction, "finite and >= 0");
    has_friction = true;
  } else if (word == "static_friction") {
    static_friction = number(lmp, who, narg, arg);
    if (!(static_friction >= 0.0 && static_friction < INFINITY))
      out_of_range(lmp, who, "static_friction", static_friction, "finite and at least friction");
  } else if (word == "conductivity") {
    conductivity = number(lmp, who, narg, arg);
    if (!(conductivity >= 0.0 && conductivity < INFINITY))
      out_of_range(lmp, who, "conductivity", conductivity, "finite and >= 0");
  } else if (word == "damping") {
    damping = number(lmp, who, narg, arg);
    has_loss = true;
    if (!(damping >= 0.0 && damping < INFINITY))
      out_of_range(lmp, who, "damping", damping, "finite and >= 0 (a time)");
  } else if (word == "restitution") {
    restitution = number(lmp, who, narg, arg);
    has_loss = true;
    if (!(restitution >= 0.01 && restitution <= 1.0))
      out_of_range(lmp, who, "restitution", restitution, "from 0.01 to 1");
  } else {
    return 0;
  }
  is_set = 1;
  if (has_young && has_shear) lmp->error->all(FLERR, who + ": young and shear are both given");
  if (damping > 0.0 && restitution < 1.0)
    lmp->error->all(FLERR, who + ": damping and restitution are both given: give one of them");
  if (has_shear && has_poisson) {
    if (!(shear > 0.0 && shear < INFINITY))
      out_of_range(lmp, who, "shear", shear, "finite and > 0");
    young = 2.0 * shear * (1.0 + poisson);
  }
  if ((has_young || has_shear) && has_poisson) has_body = 1;
  return 2;
}

bool Material::come_from_file()
{
  shear = 0.0;
  has_young = has_shear = has_poisson = has_friction = has_slip = is_rigid = false;
  has_loss = loses();
  const auto is_flag = [](int flag) { return flag == 0 || flag == 1; };
  const bool none = !is_set && !has_body;
  const bool body = !has_body || (young > 0.0 && poisson > -1.0 && poisson <= 0.5);
  const bool strength = yield >= 0.0 && yield < INFINITY;
  const bool conducts = conductivity >= 0.0 && conductivity < INFINITY;
  const bool rebounds = restitution >= 0.01 && restitution <= 1.0;
  const bool grips = static_friction == 0.0 || (static_friction >= friction && static_friction < INFINITY && !slips());
  const bool slows = friction + slip_b >= 0.0 && friction + slip_b < INFINITY && slip_c >= 0.0 && slip_c < INFINITY;
  const bool resists = std::isfinite(rolling.stiffness + rolling.damping + rolling.friction) &&
      rolling.stiffness >= 0.0 && rolling.damping >= 0.0 && rolling.friction >= 0.0;
  return is_flag(is_set) && is_flag(has_body) &&
      (none || (body && friction >= 0.0 && friction < INFINITY && damping >= 0.0 && damping < INFINITY && strength && rebounds && conducts &&
                resists && grips && slows));
}

void Material::check(LAMMPS *lmp, const std::string &who) const
{
  if (is_rigid && (has_young || has_shear || has_poisson))
    lmp->error->all(FLERR, who + ": rigid and " + (has_young ? "young" : has_shear ? "shear" : "poisson") +
                               " are both given: give one of them");
  if (has_friction && has_slip)
    lmp->error->all(FLERR, who + ": friction and slip_friction are both given: give one of them");
  if (static_friction > 0.0 && has_slip)
    lmp->error->all(FLERR, who + ": static_friction and slip_friction are both given: give one of them");
  if (static_friction != 0.0 && static_friction < friction)
    out_of_range(lmp, who, "static_friction", static_friction, "finite and at least friction");
  if (has_poisson != (has_young || has_shear))
    lmp->error->all(FLERR, who + (has_poisson ? ": poisson requires young or shear" : ": poisson is missing"));
  if (yield > 0.0 && !has_poisson) lmp->error->all(FLERR, who + ": yield requires young or shear");
  if (!has_poisson) return;
  if (!(poisson > -1.0 && poisson <= 0.5)) out_of_range(lmp, who, "poisson", poisson, "in (-1, 0.5]");
  if (!(young > 0.0 && young < INFINITY)) out_of_range(lmp, who, "young", young, "finite and > 0");
}

int Law::take(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  const std::string word = arg[0];
  if (word == "law") {
    const std::string name = narg < 2 ? "" : arg[1];
    if (carom_law_of_name(name.c_str(), &law, nullptr) != CAROM_STATUS_OK)
      lmp->error->all(FLERR, who + ": law is neither coulomb, fixed-direction nor rings: '" + name + "'");
    return 2;
  }
  if (word == "torsion") {
    torsion = flag(lmp, who, narg, arg);
    return 2;
  }
  if (word == "tolerance") {
    tolerance = number(lmp, who, narg, arg);
    if (!(tolerance > 0.0 && tolerance <= 0.1))
      out_of_range(lmp, who, "tolerance", tolerance, "> 0 and <= 0.1");
    return 2;
  }
  return 0;
}

const char *Law::name() const
{
  return carom_law_name(law);
}

MadeLaw make_law(LAMMPS *lmp, const std::string &who, const carom_material &one, const carom_material &two,
                 const Material &pair, const Law &law)
{
  if (pair.friction < 0.0) lmp->error->all(FLERR, who + ": friction is missing");
  for (const char *word : {pair.static_friction > pair.friction ? "static_friction" : "", pair.slips() ? "slip_friction" : ""}) {
    if (!*word) continue;
    if (law.by_rings()) lmp->error->all(FLERR, who + ": " + word + " needs law fixed-direction or coulomb, not rings");
    if (law.torsion) lmp->error->all(FLERR, who + ": " + word + " needs torsion no: a twist has one coefficient of friction");
  }
  carom_law_options options = {};
  options.size = sizeof options;
  options.law = law.law;
  options.torsion = law.torsion;
  options.tolerance = law.tolerance;
  options.static_friction = pair.static_friction;
  options.slip_friction_b = pair.slip_b;
  options.slip_friction_c = pair.slip_c;
  options.relaxation = pair.damping;
  options.restitution = pair.restitution;
  options.rolling = pair.rolling;
  carom_law *made = nullptr;
  carom_error error;
  if (carom_law_make(&one, &two, pair.friction, &options, &made, &error) != CAROM_STATUS_OK)
    lmp->error->all(FLERR, who + ": " + error.text);
  return MadeLaw(made, carom_law_free);
}

MadeLaw law_at_curved_wall(LAMMPS *lmp, const std::string &who, const MadeLaw &flat, double radius,
                           const double *curvature)
{
  carom_law *made = nullptr;
  carom_error error;
  if (carom_law_on_curved_wall(flat.get(), radius, curvature[0], curvature[1], &made, &error) != CAROM_STATUS_OK) {
    char text[80];
    snprintf(text, sizeof text, ": a grain of radius %g does not fit a wall of this curvature: ", radius);
    lmp->error->one(FLERR, who + text + error.text);
  }
  return MadeLaw(made, carom_law_free);
}

void tell_of_coupling(LAMMPS *lmp, const std::string &who, const MadeLaw &law)
{
  carom_validity validity;
  char text[200];
  if (lmp->comm->me != 0 ||
      carom_law_validity(law.get(), 1.0, 1.0, 0.0, &validity, nullptr) != CAROM_STATUS_OK ||
      carom_validity_text(&validity, CAROM_WARNING_COUPLING, text, sizeof text, nullptr) != CAROM_STATUS_OK ||
      text[0] == '\0')
    return;
  utils::logmesg(lmp, who + ": " + text + "; law rings has it\n");
}

}    // namespace carom
