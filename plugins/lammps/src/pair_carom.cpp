#include "pair_carom.h"

#include "conduction.h"
#include "fix_carom_keep.h"
#include "fix_wall_carom.h"
#include "host.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

// Values of single() for a contact, in the order of p1, p2, ... of compute pair/local.
enum { F_X, F_Y, F_Z, F_NORMAL, F_FRICTION, OVERLAP, AREA_RADIUS, STICKING, REGIME, ENERGY, HEAT, WHOLE_HEAT, EXTRAS };

// Number of contacts of a grain for which there is space while restart files are read.
static constexpr int FORESEEN = 64;

static std::string free_id(const Modify *modify, const std::string &stem)
{
  std::string id = stem;
  for (int k = 2; modify->get_fix_by_id(id) || modify->get_fix_by_id(id + "_DUMMY"); k++)
    id = stem + "_" + std::to_string(k);
  return id;
}

PairCarom::PairCarom(LAMMPS *lmp) : Pair(lmp)
{
  single_enable = 1;
  comm_forward = 1;    // the masses of rigid bodies
  single_extra = EXTRAS;
  svector = new double[EXTRAS];
  restartinfo = 1;
  no_virial_fdotr_compute = 1;
  finitecutflag = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  beyond_contact = 0;
  // A contact is seen from the lower tag, so that it is the same for both grains.
  nondefault_history_transfer = 1;

  // Placeholders for the fixes, in this order. The fixes are made when a run begins, since a restart file has
  // been read by then, and have these names.
  keep_id = free_id(modify, "CAROM_KEEP");
  history_id = free_id(modify, "NEIGH_HISTORY_CAROM");
  restore_id = free_id(modify, "CAROM_RESTORE");
  for (const std::string &id : {keep_id, history_id, restore_id}) {
    Fix *place = modify->add_fix(id + "_DUMMY all DUMMY", 0);
    // Grains from several restart files are moved before anything else is made.
    place->maxexchange = FORESEEN * (1 + Touches::MOST + Touches::HEATS);
  }
}

PairCarom::~PairCarom()
{
  if (copymode) return;
  delete[] svector;
  if (keep) keep->pair = nullptr;
  for (const std::string &id : {keep_id, history_id, restore_id})
    for (const std::string &name : {id, id + "_DUMMY"})
      if (modify->get_fix_by_id(name)) modify->delete_fix(name);
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

int PairCarom::place(int i, int j) const
{
  return i * (atom->ntypes + 1) + j;
}

void PairCarom::allocate()
{
  allocated = 1;
  const int n = atom->ntypes;
  memory->create(setflag, n + 1, n + 1, "pair:setflag");
  memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
  for (int i = 0; i <= n; i++)
    for (int j = 0; j <= n; j++) setflag[i][j] = 0;
  coefficients.assign((n + 1) * (n + 1), {});
  laws.assign((n + 1) * (n + 1), {});
  told.assign((n + 1) * (n + 1), 0);
  largest.assign(n + 1, 0.0);
}

void PairCarom::settings(int narg, char **arg)
{
  law_ = {};
  account = space = 0;
  carom::Given given;
  for (int k = 0; k < narg;) {
    int words = law_.take(lmp, "pair_style carom", narg - k, arg + k);
    if (words == 0 && strcmp(arg[k], "energy") == 0) {
      account = carom::flag(lmp, "pair_style carom", narg - k, arg + k);
      words = 2;
    }
    if (words == 0)
      error->all(FLERR, std::string("pair_style carom does not know '") + arg[k] +
                            "': only law, tolerance, torsion and energy");
    given.add(lmp, "pair_style carom", arg[k]);
    k += words;
  }
  if (comm->me == 0) utils::logmesg(lmp, std::string("pair_style carom: law ") + law_.name() + "\n");
}

void PairCarom::coeff(int narg, char **arg)
{
  if (narg < 2) error->all(FLERR, "pair_coeff requires two types of grains");
  if (!allocated) allocate();
  const std::string who = std::string("pair_coeff ") + arg[0] + " " + arg[1] + " of pair carom";
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  carom::Material material;
  carom::Given given;
  for (int k = 2; k < narg;) {
    const int words = material.take(lmp, who, narg - k, arg + k);
    if (words == 0)
      error->all(FLERR, who + " does not know '" + arg[k] +
                            "': only young, shear, poisson, yield, friction, static_friction, slip_friction, damping, "
                            "restitution, rolling and conductivity");
    given.add(lmp, who, arg[k]);
    k += words;
  }
  if (std::isinf(material.young))
    error->all(FLERR, who + ": rigid is for walls only; grains have young (or shear) and poisson");
  material.check(lmp, who);
  if (material.friction < 0.0) error->all(FLERR, who + ": friction is missing");
  int count = 0;
  for (int i = ilo; i <= ihi; i++) {
    for (int j = std::max(jlo, i); j <= jhi; j++, count++) {
      if (i == j && !material.has_body)
        error->all(FLERR, who + ": young (or shear) and poisson are missing");
      coefficients[place(i, j)] = material;
      setflag[i][j] = 1;
    }
  }
  if (count == 0) error->all(FLERR, who + ": no pair of types: the first must not be above the second");
}

void PairCarom::init_style()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, "pair carom requires atom_style sphere");
  if (force->ftm2v != 1.0)
    error->all(FLERR, std::string("pair carom: units = ") + update->unit_style +
                          " is out of range: must be si, cgs, lj, micro or nano, where force is mass times acceleration");
  tell_of_spin();
  if (comm->ghost_velocity == 0) error->all(FLERR, "pair carom requires comm_modify vel yes");
  conducts = std::any_of(coefficients.begin(), coefficients.end(),
                         [](const carom::Material &material) { return material.conductivity > 0.0; });
  if (conducts) carom::need_temperatures(lmp, "pair carom");
  frozen = 0;
  for (const Fix *fix : modify->get_fix_by_style("^freeze$")) frozen |= fix->groupbit;
  masses.start(modify);
  limits.start();
  make_laws();
  set_space();
  heat_readers.clear();
  neighbor->add_request(this, NeighConst::REQ_SIZE | NeighConst::REQ_HISTORY);
  if (!history) {
    const auto make = [this](const std::string &id, const std::string &style) {
      return modify->replace_fix(id + "_DUMMY", id + " all " + style, 0);
    };
    keep = static_cast<FixCaromKeep *>(make(keep_id, "CAROM_KEEP"));
    keep->check_numbers(numbers());
    history = static_cast<NeighHistory *>(make(history_id, "NEIGH_HISTORY " + std::to_string(numbers())));
    keep->serve(this, history);
    restore = static_cast<FixCaromRestore *>(make(restore_id, "CAROM_RESTORE"));
    restore->keep = keep;
    if (history->pair != nullptr)
      error->all(FLERR, "pair carom: the fields of fix NEIGH_HISTORY are not where they were expected");
    history->pair = this;
  }
  restore->make_room();
  // The largest radius of each type, grains to come included.
  std::vector<double> mine(largest.size(), 0.0);
  for (const char *style : {"^pour", "^deposit"}) {
    for (Fix *fix : modify->get_fix_by_style(style)) {
      for (int type = 1; type <= atom->ntypes; type++) {
        int asked = type;
        const auto *radius = static_cast<double *>(fix->extract("radius", asked));
        if (radius) mine[type] = std::max(mine[type], *radius);
      }
    }
  }
  for (int i = 0; i < atom->nlocal; i++)
    mine[atom->type[i]] = std::max(mine[atom->type[i]], atom->radius[i]);
  MPI_Allreduce(mine.data(), largest.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MAX, world);
}

// The size of a contact is fixed when the first run begins.
void PairCarom::set_space()
{
  int asked = 0;
  for (const carom::MadeLaw &law : laws) {
    if (!law) continue;
    touches.fit(law);
    asked = std::max(asked, static_cast<int>(carom_touch_pack_size(law.get())));
  }
  if (history && asked > space) {
    const bool slips = std::any_of(coefficients.begin(), coefficients.end(),
                                   [](const carom::Material &material) { return material.slips(); });
    const char *word = slips && asked == space + 1 ? "slip_friction" : "rolling";
    error->all(FLERR, std::string("pair carom: ") + word +
                          " must be given before the first run, at least for one pair of types");
  }
  space = std::max(space, asked);
  weighs = std::any_of(coefficients.begin(), coefficients.end(),
                       [](const carom::Material &material) { return material.restitution < 1.0; });
}

// Friction turns grains, which only some integrators follow.
void PairCarom::tell_of_spin()
{
  const auto &fixes = modify->get_fix_list();
  const auto moves = [](const Fix *fix) { return fix->time_integrate != 0; };
  const auto turns = [&](const Fix *fix) {
    const std::string style = fix->style;
    const auto has = [&](const char *part) { return style.find(part) != std::string::npos; };
    return moves(fix) && (has("sphere") || has("rigid") || has("poems") || has("move"));
  };
  const bool is_due = std::any_of(fixes.begin(), fixes.end(), moves) && std::none_of(fixes.begin(), fixes.end(), turns);
  if (is_due && !has_told_of_spin && comm->me == 0)
    error->warning(FLERR, "pair carom: no fix integrates the spin of the grains, as nve/sphere does: friction cannot turn them");
  has_told_of_spin = has_told_of_spin || is_due;
}

// The loss is that of a pair: what its two types lose among themselves is not taken over.
void PairCarom::tell_of_loss(const std::string &who, int i, int j) const
{
  if (comm->me != 0 || coefficients[place(i, j)].names_loss()) return;
  for (const int type : {i, j}) {
    if (!setflag[type][type] || !material(type).loses()) continue;
    const std::string own = std::to_string(type);
    error->warning(FLERR, who + ": neither restitution nor damping is given, so that nothing is lost along the normal; " + own +
                              " " + own + " has one: write restitution here too (1 for no loss)");
    return;
  }
}

void PairCarom::make_laws()
{
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++)
      if (setflag[i][j]) make_laws(i, j);
}

// Those of a pair of types, whichever is body 1.
void PairCarom::make_laws(int i, int j)
{
  const std::string who = "pair_coeff " + std::to_string(i) + " " + std::to_string(j) + " of pair carom";
  const carom::Material &pair = coefficients[place(i, j)];
  const bool own = pair.has_body;
  for (const int type : {i, j})
    if (!own && !material(type).has_body)
      error->all(FLERR, who + ": type " + std::to_string(type) +
                            " has no material of its own, so young and poisson are missing here");
  const carom_material one = own ? pair.body() : material(i).body();
  const carom_material two = own ? pair.body() : material(j).body();
  laws[place(i, j)] = carom::make_law(lmp, who, one, two, pair, law_);
  laws[place(j, i)] = i == j ? laws[place(i, j)] : carom::make_law(lmp, who, two, one, pair, law_);
  if (!told[place(i, j)]) {
    carom::tell_of_coupling(lmp, who, laws[place(i, j)]);
    tell_of_loss(who, i, j);
  }
  told[place(i, j)] = 1;
}

double PairCarom::init_one(int i, int j)
{
  if (!setflag[i][j])
    error->all(FLERR, "pair_coeff " + std::to_string(i) + " " + std::to_string(j) +
                          " of pair carom is missing: friction is that of a pair");
  return largest[i] + largest[j];
}

PairCarom::Bodies PairCarom::bodies() const
{
  return {atom->x[0],  atom->v[0],      atom->omega[0], atom->radius,
          weighs ? masses.all(atom) : nullptr, atom->mask, frozen, atom->f[0],
          atom->torque[0], atom->type,  atom->ntypes + 1,
          static_cast<std::size_t>(atom->nlocal + (force->newton_pair ? atom->nghost : 0))};
}

inline void PairCarom::Bodies::set(carom_grain &grain, std::size_t i) const
{
  memcpy(grain.place, x + 3 * i, sizeof grain.place);
  memcpy(grain.velocity, v + 3 * i, sizeof grain.velocity);
  memcpy(grain.spin, w + 3 * i, sizeof grain.spin);
  grain.radius = radius[i];
  if (mass) grain.mass = mask[i] & frozen ? HEAVY * mass[i] : mass[i];
}

// A grain of another rank gets its forces there, unless newton is on.
inline void PairCarom::Bodies::add(std::size_t i, const double *force_i, const double *torque_i) const
{
  if (i >= moved) return;
  double *__restrict f_i = f + 3 * i, *__restrict torque_of_i = torque + 3 * i;
  for (int k = 0; k < 3; k++) {
    f_i[k] += force_i[k];
    torque_of_i[k] += torque_i[k];
  }
}

const carom::MadeLaw &PairCarom::law_of(int body_1, int body_2) const
{
  return laws[place(atom->type[body_1], atom->type[body_2])];
}

carom_touch *PairCarom::touch_of(double *slot, int body_1, int body_2)
{
  const double *radius = atom->radius;
  carom_touch *touch = touches.at(slot, law_of(body_1, body_2), radius[body_1], radius[body_2], &why);
  if (!touch) carom::fail(lmp, "pair carom", why);
  return touch;
}

// The share of a contact's energy that this rank counts: another rank counts it too if its grain is a ghost
// that gets no force from here.
double PairCarom::share_of(int j) const
{
  return force->newton_pair || j < atom->nlocal ? 1.0 : 0.5;
}

void PairCarom::compute(int eflag, int vflag)
{
  ev_init(eflag, vflag);
  if (history->nlocal_neigh > atom->nlocal || history->nall_neigh < history->nlocal_neigh)
    error->one(FLERR, "pair carom: the fields of fix NEIGH_HISTORY are not where they were expected");
  // A setup only reads the result of the last step; a contact that is new to it begins with a step of
  // duration zero. Two separated grains that were in contact make one more step, in which the contact ends.
  const bool moves = !update->setupflag;
  if (masses.has_bodies() && (!masses.is_known() || neighbor->ago == 0)) {
    masses.refresh(atom);
    comm->forward_comm(this);
  }
  heat_readers.expire();
  grain_heat.begin(heat_readers, atom->nlocal + atom->nghost);
  const double *x = atom->nlocal ? atom->x[0] : nullptr, *radius = atom->radius;
  const tagint *tag = atom->tag;
  const int size = numbers();
  int found = 0;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], count = list->numneigh[i];
    int *flags = history->firstflag[i];
    double *slots = history->firstvalue[i];
    const int *neighbors = list->firstneigh[i];
    const double *here = x + 3 * i, radius_i = radius[i];
    for (int jj = 0; jj < count; jj++) {
      const int j = neighbors[jj] & NEIGHMASK;
      const double *there = x + 3 * j;
      const double dx = here[0] - there[0], dy = here[1] - there[1], dz = here[2] - there[2];
      const double reach = radius_i + radius[j];
      const bool apart = dx * dx + dy * dy + dz * dz >= reach * reach;
      if (apart && !flags[jj]) continue;
      Close &pair = close[found];
      pair.flag = flags + jj;
      pair.slot = slots + size * jj;
      // Without a branch: which of both is body 1 cannot be foreseen.
      pair.i_is_1 = tag[i] < tag[j];
      pair.bodies[!pair.i_is_1] = i;
      pair.bodies[pair.i_is_1] = j;
      pair.apart = apart;
      if (apart && !moves) {
        end(pair);
      } else if (++found == TOGETHER) {
        step_all(found, eflag, moves);
        found = 0;
      }
    }
  }
  step_all(found, eflag, moves);
}

// Advances the contacts that were found. Without heats they go through the library in one call.
void PairCarom::step_all(int count, int eflag, bool moves)
{
  // Contacts may move in memory while others are unpacked.
  bool is_new[TOGETHER];
  for (int k = 0; k < count; k++) {
    const Close &pair = close[k];
    is_new[k] = *pair.flag == 0;
    if (*pair.flag > 1) continue;
    touch_of(pair.slot, one_of(pair), two_of(pair));
    *pair.flag = touches.flag_of(pair.slot);
  }
  const double dt = moves ? update->dt : 0.0;
  const Bodies all = bodies();
  const double *mass = masses.all(atom);
  for (int k = 0; k < count; k++) {
    const Close &pair = close[k];
    const int one = one_of(pair), two = two_of(pair);
    carom_encounter &met = encounters[k];
    met.law = laws[all.type[one] * all.types + all.type[two]].get();
    met.touch = touches.with_flag(*pair.flag);
    all.set(met.one, one);
    all.set(met.two, two);
    if (is_new[k] && update->whichflag == 1)
      limits.begins(met.law, met.one, mass[one], met.two, mass[two], update->dt);
  }
  if (moves && limits.looks(update->ntimestep)) limits.look(encounters, count);
  if (!moves || account) {
    for (int k = 0; k < count; k++) step_alone(close[k], encounters[k], dt, moves || is_new[k]);
  } else if (carom_touch_step_many(encounters, count, dt, nullptr, &why) != CAROM_STATUS_OK) {
    carom::fail(lmp, "pair carom", why);
  }
  for (int k = 0; k < count; k++) {
    const Close &pair = close[k];
    const int one = one_of(pair), two = two_of(pair);
    const carom_encounter &met = encounters[k];
    const double *force_1 = met.load.force;
    const double force_2[3] = {-force_1[0], -force_1[1], -force_1[2]};
    all.add(one, force_1, met.load.torque_1);
    all.add(two, force_2, met.load.torque_2);
    if (conducts) conduct(met, one, two, all.moved);
    if (evflag) {
      const double energy = eflag ? energy_of(touches.with_flag(*pair.flag), one, two) : 0.0;
      tally(pair, energy, force_1, pair.i_is_1 ? 1.0 : -1.0);
    }
    if (pair.apart) end(pair);
  }
}

// Heat of the warmer grain goes to the other one; a grain of another rank gets its heat there, unless newton is on.
void PairCarom::conduct(const carom_encounter &met, int one, int two, std::size_t moved)
{
  const int low = std::min(atom->type[one], atom->type[two]), high = std::max(atom->type[one], atom->type[two]);
  const double conductivity = coefficients[place(low, high)].conductivity;
  if (conductivity == 0.0) return;
  double square = 0.0;
  for (int k = 0; k < 3; k++) square += std::pow(met.one.place[k] - met.two.place[k], 2);
  const double overlap = met.one.radius + met.two.radius - std::sqrt(square);
  const double *temperature = atom->temperature;
  const double heat = carom::conducted(conductivity, 1.0 / met.one.radius + 1.0 / met.two.radius, overlap,
                                       temperature[two] - temperature[one]);
  if (static_cast<std::size_t>(one) < moved) atom->heatflow[one] += heat;
  if (static_cast<std::size_t>(two) < moved) atom->heatflow[two] -= heat;
}

// The step of one contact, with heats if requested, or the load after the last step.
void PairCarom::step_alone(const Close &pair, carom_encounter &met, double dt, bool steps)
{
  carom_heats made = {0.0, 0.0, 0.0};
  const carom_status status =
      steps ? carom_touch_step(met.law, met.touch, &met.one, &met.two, nullptr, dt, &met.load,
                               account ? &made : nullptr, &why)
            : carom_touch_load(met.law, met.touch, &met.one, &met.two, nullptr, &met.load, &why);
  if (status != CAROM_STATUS_OK) carom::fail(lmp, "pair carom", why);
  if (!account || !steps) return;
  heats_of(pair.slot)[0] = 0.0;
  book(pair, made);
}

void PairCarom::book(const Close &pair, const carom_heats &made)
{
  const double share = share_of(j_of(pair));
  heats.friction += share * made.friction;
  heats.damping += share * made.damping;
  heats.rolling += share * made.rolling;
  const double made_here = carom::all_of(made);
  double *of_contact = heats_of(pair.slot);
  of_contact[0] += made_here;
  of_contact[1] += made_here;
  if (!grain_heat.is_wanted()) return;
  // Half to each grain; another rank counts that of its own, unless newton is on.
  grain_heat.add(i_of(pair), 0.5 * made_here);
  if (share == 1.0) grain_heat.add(j_of(pair), 0.5 * made_here);
}

double PairCarom::energy_of(const carom_touch *touch, int body_1, int body_2) const
{
  double energy = 0.0;
  const double *radius = atom->radius;
  carom_touch_energy(law_of(body_1, body_2).get(), touch, radius[body_1], radius[body_2], &energy, nullptr);
  return energy;
}

void PairCarom::tally(const Close &pair, double energy, const double *force_1, double sign)
{
  const double *x = atom->x[i_of(pair)], *y = atom->x[j_of(pair)];
  ev_tally_xyz(i_of(pair), j_of(pair), atom->nlocal, force->newton_pair, energy, 0.0, sign * force_1[0],
               sign * force_1[1], sign * force_1[2], x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

void PairCarom::end(const Close &pair)
{
  touches.drop(pair.slot);
  memset(pair.slot, 0, numbers() * sizeof(double));
  *pair.flag = 0;
}

void PairCarom::tell_of_limits(bool is_end)
{
  std::vector<carom::Limits::Of> styles = {{"pair carom", &limits}};
  for (Fix *fix : modify->get_fix_by_style("^wall/carom$")) {
    auto *wall = static_cast<FixWallCarom *>(fix);
    if (wall->is_of(this)) styles.push_back({wall->who(), &wall->limits});
  }
  carom::Limits::tell(lmp, styles, is_end);
}

void PairCarom::pack_all()
{
  // Nothing was unpacked since the list was built, or there is no list yet.
  if (!history || !list || !history->firstflag) return;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    int *flags = history->firstflag[i];
    double *slots = history->firstvalue[i];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      if (!flags[jj]) continue;
      double *slot = slots + numbers() * jj;
      if (touches.pack(slot, &why) != CAROM_STATUS_OK)
        carom::fail(lmp, "pair carom", why);
      flags[jj] = 1;
    }
  }
}

double PairCarom::stored_energy()
{
  double sum = 0.0;
  if (!history || !list) return sum;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      double *slot = history->firstvalue[i] + numbers() * jj;
      if (slot[0] == 0.0) continue;
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const bool i_is_1 = atom->tag[i] < atom->tag[j];
      const int one = i_is_1 ? i : j, two = i_is_1 ? j : i;
      sum += share_of(j) * energy_of(touch_of(slot, one, two), one, two);
    }
  }
  return sum;
}

// The slot of a pair, if it is in the list of this rank.
double *PairCarom::find_slot(int i, int j) const
{
  for (int turn = 0; turn < 2; turn++, std::swap(i, j)) {
    if (i >= atom->nlocal) continue;
    for (int jj = 0; jj < list->numneigh[i]; jj++)
      if ((list->firstneigh[i][jj] & NEIGHMASK) == j)
        return history->firstvalue[i] + numbers() * jj;
  }
  return nullptr;
}

double PairCarom::single(int i, int j, int itype, int jtype, double rsq, double, double, double &fforce)
{
  fforce = 0.0;
  std::fill(svector, svector + EXTRAS, 0.0);
  double *slot = history && list ? find_slot(i, j) : nullptr;
  if (!slot || slot[0] == 0.0) return 0.0;
  const bool i_is_1 = atom->tag[i] < atom->tag[j];
  const int one = i_is_1 ? i : j, two = i_is_1 ? j : i;
  const carom_law *law = laws[i_is_1 ? place(itype, jtype) : place(jtype, itype)].get();
  carom_grain body_1 = {}, body_2 = {};
  const Bodies all = bodies();
  all.set(body_1, one);
  all.set(body_2, two);
  const carom_touch *touch = touch_of(slot, one, two);
  carom_grain_load load;
  carom_report report;
  if (carom_touch_load(law, touch, &body_1, &body_2, nullptr, &load, &why) != CAROM_STATUS_OK ||
      carom_touch_report(law, touch, &report, &why) != CAROM_STATUS_OK)
    carom::fail(lmp, "pair carom", why);
  const double energy = energy_of(touch, one, two);
  const double distance = sqrt(rsq), overlap = atom->radius[i] + atom->radius[j] - distance;
  double normal_force = 0.0, square = 0.0;
  for (int k = 0; k < 3; k++)
    normal_force += load.force[k] * (body_1.place[k] - body_2.place[k]) / distance;
  for (int k = 0; k < 3; k++) {
    const double friction =
        load.force[k] - normal_force * (body_1.place[k] - body_2.place[k]) / distance;
    square += friction * friction;
    svector[F_X + k] = i_is_1 ? friction : -friction;
  }
  const double relative = 1.0 / (1.0 / atom->radius[i] + 1.0 / atom->radius[j]);
  svector[F_NORMAL] = normal_force;
  svector[F_FRICTION] = sqrt(square);
  svector[OVERLAP] = overlap;
  svector[AREA_RADIUS] = sqrt(relative * std::max(overlap, 0.0));
  svector[STICKING] = report.sticking;
  svector[REGIME] = report.regime;
  svector[ENERGY] = energy;
  if (account) std::copy_n(heats_of(slot), Touches::HEATS, svector + HEAT);
  fforce = normal_force / distance;
  return energy;
}

void PairCarom::transfer_history(double *source, double *target, int, int)
{
  memcpy(target, source, numbers() * sizeof(double));
}

void PairCarom::write_restart_settings(FILE *fp)
{
  fwrite(&law_, sizeof law_, 1, fp);
  fwrite(&account, sizeof account, 1, fp);
  fwrite(&space, sizeof space, 1, fp);
}

void PairCarom::read_restart_settings(FILE *fp)
{
  if (comm->me == 0) {
    utils::sfread(FLERR, &law_, sizeof law_, 1, fp, nullptr, error);
    utils::sfread(FLERR, &account, sizeof account, 1, fp, nullptr, error);
    utils::sfread(FLERR, &space, sizeof space, 1, fp, nullptr, error);
  }
  MPI_Bcast(&law_, sizeof law_, MPI_BYTE, 0, world);
  MPI_Bcast(&account, sizeof account, MPI_BYTE, 0, world);
  MPI_Bcast(&space, sizeof space, MPI_BYTE, 0, world);
  const auto is_flag = [](int flag) { return flag == 0 || flag == 1; };
  const bool has_space = space >= 0 && space <= Touches::MOST;
  if (!law_.is_known() || !is_flag(law_.torsion) || !is_flag(account) || !has_space || !(law_.tolerance >= 0.0 && law_.tolerance <= 0.1))
    error->all(FLERR, "pair carom: the restart file is damaged: law, tolerance, torsion, energy or the space of a contact is not valid");
}

// Of the contacts, by the library, and of what this style writes beside them.
static uint32_t file_version()
{
  constexpr uint32_t OF_STYLE = 7;
  return 1000 * OF_STYLE + CAROM_STATE_VERSION;
}

void PairCarom::write_restart(FILE *fp)
{
  const uint32_t version = file_version();
  fwrite(&version, sizeof version, 1, fp);
  write_restart_settings(fp);
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      carom::Material &material = coefficients[place(i, j)];
      if (!setflag[i][j]) material = {};
      fwrite(&material, sizeof material, 1, fp);
    }
}

void PairCarom::read_restart(FILE *fp)
{
  uint32_t version = 0;
  if (comm->me == 0) utils::sfread(FLERR, &version, sizeof version, 1, fp, nullptr, error);
  MPI_Bcast(&version, sizeof version, MPI_BYTE, 0, world);
  if (version != file_version())
    error->all(FLERR, "pair carom: the restart file was written by another version of carom (" +
                          std::to_string(version) + ")");
  read_restart_settings(fp);
  allocate();
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i; j <= atom->ntypes; j++) {
      carom::Material &material = coefficients[place(i, j)];
      if (comm->me == 0) utils::sfread(FLERR, &material, sizeof material, 1, fp, nullptr, error);
      MPI_Bcast(&material, sizeof material, MPI_BYTE, 0, world);
      if (!material.come_from_file())
        error->all(FLERR, "pair carom: the restart file is damaged: the material of types " + std::to_string(i) +
                              " and " + std::to_string(j) + " is not valid");
      setflag[i][j] = material.is_set;
    }
}

double PairCarom::memory_usage()
{
  return Pair::memory_usage() + touches.bytes();
}
