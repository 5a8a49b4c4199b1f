#include "fix_wall_carom.h"

#include "find_pair.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

// Number of values of the whole wall in a restart file: position, sums, force.
static constexpr int KEPT = 10;

// Values of compute_vector(), from f_ID[1] on.
enum { FORCE_X, FORCE_Y, FORCE_Z, STORED, FRICTION, DAMPING, WORK, ROLLING, OUTPUTS };

FixWallCarom::FixWallCarom(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  for (int k = 3; k < narg;) {
    const std::string word = arg[k];
    int words = material.take(lmp, who(), narg - k, arg + k);
    if (words == 0) {
      words = law.take(lmp, who(), narg - k, arg + k);
      has_law = has_law || (words > 0 && word == "law");
      has_tolerance = has_tolerance || (words > 0 && word == "tolerance");
      has_torsion = has_torsion || (words > 0 && word == "torsion");
    }
    if (words == 0 && word == "plane" && k + 6 < narg) {
      for (int axis = 0; axis < 3; axis++) {
        wall.place[axis] = utils::numeric(FLERR, arg[k + 1 + axis], false, lmp);
        wall.normal[axis] = utils::numeric(FLERR, arg[k + 4 + axis], false, lmp);
      }
      has_plane = true;
      words = 7;
    }
    if (words == 0 && word == "velocity" && k + 3 < narg) {
      for (int axis = 0; axis < 3; axis++)
        wall.velocity[axis] = utils::numeric(FLERR, arg[k + 1 + axis], false, lmp);
      words = 4;
    }
    if (words == 0)
      error->all(FLERR, who() + " does not know '" + word +
                            "': only plane and velocity (with all their values), young, shear, poisson, "
                            "rigid, yield, friction, damping, rolling, law, tolerance and torsion");
    k += words;
  }
  material.check(lmp, who());
  if (!has_plane) error->all(FLERR, who() + ": plane x y z nx ny nz is missing");
  if (!material.has_body) error->all(FLERR, who() + ": young (or shear) and poisson, or rigid, are missing");
  if (material.friction < 0.0) error->all(FLERR, who() + ": friction is missing");
  double *n = wall.normal;
  const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0.0 && length < INFINITY))
    error->all(FLERR, who() + ": the normal of the plane is zero");
  for (int axis = 0; axis < 3; axis++) n[axis] /= length;

  restart_global = restart_peratom = 1;
  create_attribute = 1;
  maxexchange = 1 + SLOT;
  vector_flag = 1;
  size_vector = OUTPUTS;
  global_freq = 1;
  extvector = 1;
  time_depend = 1;
  FixWallCarom::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

FixWallCarom::~FixWallCarom()
{
  if (copymode) return;
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

int FixWallCarom::setmask()
{
  return FixConst::POST_FORCE;
}

carom::Law FixWallCarom::law_with(carom::Law its) const
{
  if (has_law) its.law = law.law;
  if (has_tolerance) its.tolerance = law.tolerance;
  if (has_torsion) its.torsion = law.torsion;
  return its;
}

void FixWallCarom::init()
{
  if (!atom->radius_flag || !atom->rmass_flag || !atom->omega_flag || !atom->torque_flag)
    error->all(FLERR, who() + " requires atom_style sphere");
  for (int axis = 0; axis < 3; axis++)
    if (domain->periodicity[axis] && wall.normal[axis] != 0.0)
      error->all(FLERR, who() + ": the box is periodic across the wall");
  const auto pairs = carom::find_pairs(force);
  if (pairs.empty()) error->all(FLERR, who() + " requires pair_style carom: grains get their material there");
  account = false;
  constants.assign(atom->ntypes + 1, {});
  known.assign(atom->ntypes + 1, 0);
  pair = pairs.front();
  twists = law_with(pair->law()).torsion;
  limits.start();
  for (const PairCarom *style : pairs) {
    account = account || style->keeps_account();
    for (int type = 1; type <= atom->ntypes; type++) {
      if (known[type] || !style->material(type).has_body) continue;
      known[type] = 1;
      const carom::Law its = law_with(style->law());
      constants[type] = carom::constants_of(lmp, who(), style->material(type).body(), material.body(), material, its);
      if (!has_told) carom::tell_of_coupling(lmp, who() + ": grains of type " + std::to_string(type), constants[type]);
    }
  }
  has_told = true;
}

carom::Touch FixWallCarom::touch_of(int i)
{
  double *slot = slots[i].get();
  carom_error why;
  const carom::Touch touch = touches.at(slot, constants[atom->type[i]], atom->radius[i], INFINITY, &why);
  if (!touch) carom::fail(lmp, who(), why);
  return touch;
}

// One step of a grain on the wall, with its heat. A step of duration zero only reads, except for a new
// contact.
carom_grain_load FixWallCarom::step(int i, double duration)
{
  const double *x = atom->x[i], *v = atom->v[i], *w = atom->omega[i];
  const carom_grain grain = {{x[0], x[1], x[2]}, {v[0], v[1], v[2]}, {w[0], w[1], w[2]}, atom->radius[i]};
  const carom::Constants &its = constants[atom->type[i]];
  const bool is_new = slots[i][0] == 0.0;
  if (is_new && update->whichflag == 1) limits.begins(its.grains, grain, atom->rmass[i], wall, update->dt);
  const carom::Touch touch = touch_of(i);
  carom_grain_load load;
  carom_error why;
  carom_status status;
  if (duration > 0.0 || is_new) {
    carom_heats made = {0.0, 0.0};
    status = touch.step(its, grain, wall, duration, &load, account ? &made : nullptr, &why);
    book(i, {made.friction, made.damping, 0.0});
  } else {
    status = touch.load(its, grain, wall, &load, &why);
  }
  if (twists && !its.rings && status == CAROM_STATUS_OK) {
    carom_heats made = {0.0, 0.0};
    status = carom_touch_twist_wall(&its.grains, Touches::twist_of(slots[i].get()), &grain, &wall, duration, &load,
                                    account ? &made : nullptr, &why);
    book(i, {made.friction, made.damping, 0.0});
  }
  if (status != CAROM_STATUS_OK) carom::fail(lmp, who(), why);
  if (its.rolls()) roll(i, grain, duration, load);
  return load;
}

void FixWallCarom::roll(int i, const carom_grain &grain, double duration, carom_grain_load &load)
{
  const carom::Constants &its = constants[atom->type[i]];
  carom_surface surface = {};
  memcpy(surface.place, wall.place, sizeof surface.place);
  memcpy(surface.normal, wall.normal, sizeof surface.normal);
  carom::HeatSums made;
  carom_error why;
  if (carom_touch_roll_surface(&its.grains, &its.rolling, roll_of(slots[i].get()), &grain, &surface, duration, &load,
                               &made.rolling, &why) != CAROM_STATUS_OK)
    carom::fail(lmp, who(), why);
  if (account) book(i, made);
}

void FixWallCarom::book(int i, const carom::HeatSums &made)
{
  sums_.friction += made.friction;
  sums_.damping += made.damping;
  sums_.rolling += made.rolling;
  if (grain_heat.is_wanted()) grain_heat.add(i, made.all());
}

void FixWallCarom::post_force(int)
{
  grain_heat.begin(pair->heat_readers, atom->nlocal);
  const double duration = update->setupflag ? 0.0 : update->dt;
  for (int axis = 0; axis < 3; axis++) wall.place[axis] += duration * wall.velocity[axis];
  const double *n = wall.normal, *p = wall.place;
  const bool looks = duration > 0.0 && carom::Limits::looks(update->ntimestep);
  double sum[3] = {0.0, 0.0, 0.0};
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double *x = atom->x[i];
    const double height = (x[0] - p[0]) * n[0] + (x[1] - p[1]) * n[1] + (x[2] - p[2]) * n[2];
    const bool apart = height >= atom->radius[i];
    if (apart && !touches_wall(i)) continue;
    if (apart && duration == 0.0) {
      drop(i);
      continue;
    }
    if (!known[atom->type[i]])
      error->one(FLERR, who() + ": pair_coeff of pair carom sets no material for grains of type " +
                            std::to_string(atom->type[i]));
    slot_of(i);
    if (looks) limits.look(constants[atom->type[i]].grains, atom->radius[i], atom->radius[i] - height);
    const carom_grain_load load = step(i, duration);
    for (int axis = 0; axis < 3; axis++) {
      atom->f[i][axis] += load.force[axis];
      atom->torque[i][axis] += load.torque_1[axis];
      sum[axis] -= load.force[axis];
    }
    if (apart) drop(i);
  }
  for (int axis = 0; axis < 3; axis++) {
    sums_.work -= 0.5 * (force_on_wall[axis] + sum[axis]) * wall.velocity[axis] * duration;
    force_on_wall[axis] = sum[axis];
  }
}

double FixWallCarom::stored_energy()
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!touches_wall(i)) continue;
    const carom::Constants &its = constants[atom->type[i]];
    sum += touch_of(i).energy(its, atom->radius[i], INFINITY);
    double energy = 0.0;
    if (its.rolls()) carom_touch_roll_energy(&its.rolling, roll_of(slots[i].get()), &energy, nullptr);
    sum += energy;
    if (!twists || its.rings) continue;
    carom_touch_twist_energy(&its.grains, Touches::twist_of(slots[i].get()), atom->radius[i],
                             INFINITY, &energy, nullptr);
    sum += energy;
  }
  return sum;
}

double FixWallCarom::compute_vector(int n)
{
  double mine = 0.0;
  switch (n) {
    case STORED: mine = stored_energy(); break;
    case FRICTION: mine = sums_.friction; break;
    case DAMPING: mine = sums_.damping; break;
    case WORK: mine = sums_.work; break;
    case ROLLING: mine = sums_.rolling; break;
    default: mine = force_on_wall[n];
  }
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

// The position of the wall, and the sums of all ranks.
void FixWallCarom::write_restart(FILE *fp)
{
  const double mine[7] = {sums_.friction,   sums_.damping,    sums_.work,    force_on_wall[0],
                          force_on_wall[1], force_on_wall[2], sums_.rolling};
  double all[KEPT];
  memcpy(all, wall.place, 3 * sizeof(double));
  MPI_Reduce(mine, all + 3, 7, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  const int size = sizeof all;
  fwrite(&size, sizeof size, 1, fp);
  fwrite(all, sizeof(double), KEPT, fp);
}

void FixWallCarom::restart(char *buffer)
{
  const double *all = reinterpret_cast<double *>(buffer);
  if (!std::all_of(all, all + KEPT, [](double number) { return std::isfinite(number); }))
    damaged("the position or a sum of the wall is not a finite number");
  memcpy(wall.place, all, 3 * sizeof(double));
  if (comm->me != 0) return;
  sums_ = {all[3], all[4], all[5]};
  sums_.rolling = all[9];
  memcpy(force_on_wall, all + 6, 3 * sizeof(double));
}

void FixWallCarom::grow_arrays(int nmax)
{
  slots.resize(nmax);
}

// A grain moves to another index; what was stored there is no longer used.
void FixWallCarom::copy_arrays(int i, int j, int)
{
  std::swap(slots[i], slots[j]);
}

void FixWallCarom::drop(int i)
{
  if (!slots[i]) return;
  touches.drop(slots[i].get());
  memset(slots[i].get(), 0, SLOT * sizeof(double));
}

// Number of values kept for a grain.
int FixWallCarom::count_of(int i) const
{
  if (!touches_wall(i)) return 0;
  const int more = keeps_more() ? Touches::AT_WALL : 0;
  if (touches.is_of_rings(slots[i].get())) return Touches::OF_RINGS + more;
  return (twists ? Touches::WITH_TWIST : Touches::NUMBERS) + more;
}

// A slot has space for any law: a restart file is read before the law is known.
double *FixWallCarom::slot_of(int i)
{
  if (!slots[i]) slots[i].reset(new double[SLOT]());
  return slots[i].get();
}

void FixWallCarom::set_arrays(int i)
{
  drop(i);
}

void FixWallCarom::pack(int i)
{
  carom_error why;
  if (slots[i] && touches.pack(slots[i].get(), &why) != CAROM_STATUS_OK) carom::fail(lmp, who(), why);
}

int FixWallCarom::pack_exchange(int i, double *buffer)
{
  pack(i);
  const int count = count_of(i), more = count > 0 && keeps_more() ? Touches::AT_WALL : 0;
  buffer[0] = count;
  if (count > 0) memcpy(buffer + 1, slots[i].get(), (count - more) * sizeof(double));
  if (more > 0) memcpy(buffer + 1 + count - more, slots[i].get() + Touches::MOST, more * sizeof(double));
  return 1 + count;
}

int FixWallCarom::unpack_exchange(int i, double *buffer)
{
  drop(i);
  if (!Touches::is_count(buffer[0])) damaged(std::to_string(buffer[0]) + " numbers of a contact");
  const int count = static_cast<int>(buffer[0]);
  if (count == 0) return 1;
  const int more = Touches::is_count_of_touch(count) ? 0 : Touches::AT_WALL;
  memcpy(slot_of(i), buffer + 1, (count - more) * sizeof(double));
  memcpy(slot_of(i) + Touches::MOST, buffer + 1 + count - more, more * sizeof(double));
  return 1 + count;
}

int FixWallCarom::pack_restart(int i, double *buffer)
{
  buffer[0] = 1 + pack_exchange(i, buffer + 1);
  return static_cast<int>(buffer[0]);
}

void FixWallCarom::unpack_restart(int i, int nth)
{
  const int at = Touches::part_of(atom->extra[i], atom->nextra_store, nth);
  if (at < 0) damaged("grain " + std::to_string(atom->tag[i]) + " has another number of values than stated");
  unpack_exchange(i, atom->extra[i] + at + 1);
}

void FixWallCarom::damaged(const std::string &what) const
{
  error->one(FLERR, who() + ": the restart file is damaged: " + what);
}

int FixWallCarom::size_restart(int i)
{
  return 2 + count_of(i);
}

int FixWallCarom::maxsize_restart()
{
  return 2 + SLOT;
}

double FixWallCarom::memory_usage()
{
  return touches.bytes() + static_cast<double>(slots.capacity() * sizeof(slots[0]));
}
