#include "fix_wall_carom.h"

#include "conduction.h"
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

// Number of values of the whole wall in a restart file: position; heats and work, force and torque, heat conducted.
static constexpr int SUMS = 11;
static constexpr int KEPT = carom::WallShape::NUMBERS + SUMS;

// Constants of curved walls beyond this number are computed again: grains of as many radii.
static constexpr std::size_t MOST_CURVED = 100000;

// Values of compute_vector(), from f_ID[1] on.
enum { FORCE_X, FORCE_Y, FORCE_Z, STORED, FRICTION, DAMPING, WORK, ROLLING, TORQUE_X, TORQUE_Y, TORQUE_Z, CONDUCTED, OUTPUTS };

FixWallCarom::FixWallCarom(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  carom::Given given;
  for (int k = 3; k < narg;) {
    const std::string word = arg[k];
    int words = material.take(lmp, who(), narg - k, arg + k);
    if (words == 0) {
      words = law.take(lmp, who(), narg - k, arg + k);
      has_law = has_law || (words > 0 && word == "law");
      has_tolerance = has_tolerance || (words > 0 && word == "tolerance");
      has_torsion = has_torsion || (words > 0 && word == "torsion");
    }
    if (words == 0 && word == "temperature") {
      if (narg - k < 2) error->all(FLERR, who() + ": temperature requires a value");
      temperature = carom::numeric(lmp, who(), arg + k, 1);
      if (!std::isfinite(temperature)) error->all(FLERR, who() + ": temperature is out of range: must be finite");
      has_temperature = true;
      words = 2;
    }
    if (words == 0) words = wall.take(lmp, who(), narg - k, arg + k);
    if (words == 0)
      error->all(FLERR, who() + " does not know '" + word +
                            "': only plane, cylinder, cone, sphere, stl, scale, smooth, edges, between, velocity, omega, center, "
                            "young, shear, poisson, rigid, yield, friction, static_friction, slip_friction, damping, restitution, rolling, conductivity, temperature, law, tolerance and torsion");
    given.add(lmp, who(), word);
    k += words;
  }
  material.check(lmp, who());
  wall.check(lmp, who());
  if (!material.has_body) error->all(FLERR, who() + ": young (or shear) and poisson, or rigid, are missing");
  if (material.friction < 0.0) error->all(FLERR, who() + ": friction is missing");
  if (has_temperature != (material.conductivity > 0.0))
    error->all(FLERR, who() + (has_temperature ? ": temperature requires conductivity" : ": conductivity requires the temperature of the wall"));
  restart_global = restart_peratom = 1;
  create_attribute = 1;
  maxexchange = maxsize_restart() - 1;
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
  if (has_temperature) carom::need_temperatures(lmp, who());
  for (int axis = 0; axis < 3; axis++)
    if (domain->periodicity[axis] && !wall.extends_along(axis))
      error->all(FLERR, who() + ": the box is periodic along " + "xyz"[axis] + ", where " + wall.why_not_along(axis) +
                            ": must be bounded there");
  if (wall.is_mesh()) wall.repeat(lmp, who());
  const auto pairs = carom::find_pairs(force);
  if (pairs.empty()) error->all(FLERR, who() + " requires pair_style carom: grains get their material there");
  account = false;
  flat.assign(atom->ntypes + 1, {});
  curved.clear();
  pair = pairs.front();
  limits.start();
  for (const PairCarom *style : pairs) {
    account = account || style->keeps_account();
    for (int type = 1; type <= atom->ntypes; type++) {
      if (flat[type] || !style->material(type).has_body) continue;
      const carom::Law its = law_with(style->law());
      if (its.by_rings() && !wall.is_round())
        error->all(FLERR, who() + ": law rings needs a plane, a sphere or an STL file without edges; other walls need law coulomb or fixed-direction");
      flat[type] = carom::make_law(lmp, who(), style->material(type).body(), material.body(), material, its);
      if (!has_told) carom::tell_of_coupling(lmp, who() + ": grains of type " + std::to_string(type), flat[type]);
    }
  }
  has_told = true;
}

// The law of a contact of a grain: that of the curvature where it began.
const carom::MadeLaw &FixWallCarom::law_of(int i, const Contact &contact)
{
  const int type = atom->type[i];
  const double *curvature = contact.began.curvature;
  if (!wall.is_curved() || (curvature[0] == 0.0 && curvature[1] == 0.0)) return flat[type];
  const double radius = atom->radius[i];
  const auto found = curved.find({static_cast<double>(type), radius, curvature[0], curvature[1]});
  return found != curved.end() ? found->second : make_curved(type, radius, curvature);
}

const carom::MadeLaw &FixWallCarom::make_curved(int type, double radius, const double *curvature)
{
  if (std::isnan(curvature[0] + curvature[1])) damaged("a curvature is not a number");
  return curved[{static_cast<double>(type), radius, curvature[0], curvature[1]}] =
             carom::law_at_curved_wall(lmp, who(), flat[type], radius, curvature);
}

carom_touch *FixWallCarom::touch_of(int i, Contact &contact)
{
  carom_error why;
  carom_touch *touch = contact.touch(law_of(i, contact), atom->radius[i], &why);
  if (!touch) carom::fail(lmp, who(), why);
  return touch;
}

// A new contact keeps how the wall is there; one that goes on at a mesh comes from where it was a step ago.
void FixWallCarom::begin_or_carry(Contact &contact, carom::WallShape::Near &near) const
{
  Contact::Began &began = contact.began;
  if (!contact.is_in_use()) {
    std::copy_n(near.curvature, 2, began.curvature);
    if (wall.is_mesh()) std::copy_n(near.own_axis, 3, began.axis);
  } else if (wall.is_mesh()) {
    wall.carry_axis(began.axis, near);
  }
  if (wall.is_mesh()) std::copy_n(near.own_normal, 3, began.normal);
}

// One step of a grain on the wall, with its heat. A step of duration zero only reads, except for a new
// contact.
carom_grain_load FixWallCarom::step(int i, Contact &contact, carom::WallShape::Near &near, double duration)
{
  const double *x = atom->x[i], *v = atom->v[i], *w = atom->omega[i];
  const carom_grain grain = {{x[0], x[1], x[2]}, {v[0], v[1], v[2]}, {w[0], w[1], w[2]}, atom->radius[i],
                             pair->mass_of(i)};
  const bool is_new = !contact.is_in_use();
  begin_or_carry(contact, near);
  carom_surface surface;
  memcpy(surface.place, near.place, sizeof surface.place);
  memcpy(surface.normal, near.normal, sizeof surface.normal);
  memcpy(surface.axis, near.axis, sizeof surface.axis);
  memcpy(surface.spin, wall.omega(), sizeof surface.spin);
  wall.velocity_at(near.place, near.normal, v, duration, surface.velocity);
  carom_touch *touch = touch_of(i, contact);
  const carom_law *law = law_of(i, contact).get();
  if (is_new && update->whichflag == 1) limits.begins(law, grain, grain.mass, surface, update->dt);
  carom_grain_load load;
  carom_error why;
  carom_heats made = {0.0, 0.0, 0.0};
  const bool steps = duration > 0.0 || is_new;
  const carom_status status = steps ? carom_touch_step(law, touch, &grain, nullptr, &surface, duration, &load,
                                                       account ? &made : nullptr, &why)
                                    : carom_touch_load(law, touch, &grain, nullptr, &surface, &load, &why);
  if (status != CAROM_STATUS_OK) carom::fail(lmp, who(), why);
  book(i, made);
  return load;
}

// The wall keeps its temperature. Its curvature is above 0 where it is convex.
void FixWallCarom::conduct(int i, const carom::WallShape::Near &near, double duration)
{
  const double radius = atom->radius[i];
  const double curvature = 1.0 / radius + 0.5 * (near.curvature[0] + near.curvature[1]);
  const double heat = carom::conducted(material.conductivity, curvature, radius - near.height,
                                       temperature - atom->temperature[i]);
  atom->heatflow[i] += heat;
  sums_.conducted += heat * duration;
}

void FixWallCarom::book(int i, const carom_heats &made)
{
  sums_.friction += made.friction;
  sums_.damping += made.damping;
  sums_.rolling += made.rolling;
  if (grain_heat.is_wanted()) grain_heat.add(i, carom::all_of(made));
}

void FixWallCarom::post_force(int)
{
  grain_heat.begin(pair->heat_readers, atom->nlocal);
  const double duration = update->setupflag ? 0.0 : update->dt;
  if (wall.is_mesh() && !wall.has_periods_of(lmp))
    error->all(FLERR, who() + ": the box has changed where it is periodic: must stay as it was when the run began, since the surface repeats itself there");
  wall.move(duration);
  if (curved.size() > MOST_CURVED) curved.clear();
  const bool looks = duration > 0.0 && carom::Limits::looks(update->ntimestep);
  Reaction sum;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit) meet(i, duration, looks, sum);
  for (int axis = 0; axis < 3; axis++) {
    sums_.work -= 0.5 * (force_on_wall[axis] + sum.force[axis]) * wall.velocity()[axis] * duration;
    sums_.work -= 0.5 * (torque_on_wall[axis] + sum.torque[axis]) * wall.omega()[axis] * duration;
    force_on_wall[axis] = sum.force[axis];
    torque_on_wall[axis] = sum.torque[axis];
  }
}

// A step of all contacts of a grain.
void FixWallCarom::meet(int i, double duration, bool looks, Reaction &sum)
{
  const double radius = atom->radius[i];
  carom_error why;
  const int count = wall.near(atom->x[i], radius, nears, &why);
  if (count < 0) carom::fail(lmp, who(), why);
  if (count > carom::WallShape::MOST)
    error->one(FLERR, who() + ": grain " + std::to_string(atom->tag[i]) + " touches the wall in more than " +
                          std::to_string(carom::WallShape::MOST) + " places");
  assign(i, count);
  for (int n = 0; n < count; n++) {
    carom::WallShape::Near &near = nears[n];
    const bool apart = near.height >= radius;
    const int at = contact_at[n];
    if (apart && at < 0) continue;
    if (apart && duration == 0.0) {
      contacts[i][at].drop();
      continue;
    }
    if (near.is_refused && !apart) refuse(i, near);
    if (!flat[atom->type[i]])
      error->one(FLERR, who() + ": pair_coeff of pair carom sets no material for grains of type " +
                            std::to_string(atom->type[i]));
    Contact &contact = at < 0 ? free_contact(i) : contacts[i][at];
    touch(i, contact, near, duration, sum);
    if (looks) limits.look(law_of(i, contact).get(), radius, radius - near.height);
    if (apart) contact.drop();
  }
}

// Which contact of a grain goes on at each place; of a mesh that with the same normal, as nearly as may be. Contacts for
// which there is no place end.
void FixWallCarom::assign(int i, int count)
{
  auto &its = contacts[i];
  unsigned gone_on = 0;
  std::fill_n(contact_at, std::min(count, carom::WallShape::MOST), -1);
  const auto take = [&](int place, int its_own) {
    contact_at[place] = its_own;
    gone_on |= 1u << its_own;
  };
  if (its.empty()) return;
  if (!wall.is_mesh()) {
    if (count > 0 && its[0].is_in_use()) take(0, 0);
  } else {
    for (bool is_found = true; is_found;) {
      double best = wall.cosine_of_smooth();
      int place = -1, best_of = -1;
      for (int n = 0; n < count; n++) {
        if (contact_at[n] >= 0) continue;
        const double *normal = nears[n].own_normal;
        for (std::size_t k = 0; k < its.size(); k++) {
          if (!its[k].is_in_use() || (gone_on >> k & 1)) continue;
          const double *old = its[k].began.normal;
          const double cosine = normal[0] * old[0] + normal[1] * old[1] + normal[2] * old[2];
          if (!(cosine >= best)) continue;
          best = cosine;
          place = n;
          best_of = static_cast<int>(k);
        }
      }
      is_found = place >= 0;
      if (is_found) take(place, best_of);
    }
  }
  for (std::size_t k = 0; k < its.size(); k++)
    if (its[k].is_in_use() && !(gone_on >> k & 1)) let_go(i, its[k]);
}

// A step of a contact: the grain gets its load, the wall what is opposite.
void FixWallCarom::touch(int i, Contact &contact, carom::WallShape::Near &near, double duration, Reaction &sum)
{
  const carom_grain_load load = step(i, contact, near, duration);
  if (has_temperature) conduct(i, near, duration);
  const double *f = load.force, *center = wall.center(), *x = atom->x[i];
  const double arm[3] = {x[0] - center[0], x[1] - center[1], x[2] - center[2]};
  for (int axis = 0; axis < 3; axis++) {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    atom->f[i][axis] += f[axis];
    atom->torque[i][axis] += load.torque_1[axis];
    sum.force[axis] -= f[axis];
    sum.torque[axis] -= arm[next] * f[last] - arm[last] * f[next] + load.torque_1[axis];
  }
}

void FixWallCarom::refuse(int i, const carom::WallShape::Near &near) const
{
  const double *x = atom->x[i];
  char place[120];
  snprintf(place, sizeof place, " at (%g, %g, %g)", x[0], x[1], x[2]);
  error->one(FLERR, who() + ": grain " + std::to_string(atom->tag[i]) + place + " touches " + wall.name_of(near) +
                        " of the file, where a flat contact has no meaning: give the wall a radius of its edges, as in "
                        "'edges 1e-4', or keep grains away from it");
}

// A contact whose grain has come to the other side of the wall: what it stored is heat.
void FixWallCarom::let_go(int i, Contact &contact)
{
  if (account) book(i, {energy_of(i, contact), 0.0, 0.0});
  contact.drop();
}

double FixWallCarom::energy_of(int i, Contact &contact)
{
  double energy = 0.0;
  const carom_touch *touch = touch_of(i, contact);
  carom_touch_energy(law_of(i, contact).get(), touch, atom->radius[i], INFINITY, &energy, nullptr);
  return energy;
}

double FixWallCarom::stored_energy()
{
  double sum = 0.0;
  for (int i = 0; i < atom->nlocal; i++)
    for (Contact &contact : contacts[i])
      if (contact.is_in_use()) sum += energy_of(i, contact);
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
    case CONDUCTED: mine = sums_.conducted; break;
    case TORQUE_X: case TORQUE_Y: case TORQUE_Z: mine = torque_on_wall[n - TORQUE_X]; break;
    default: mine = force_on_wall[n];
  }
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

// The position of the wall, and the sums of all ranks.
void FixWallCarom::write_restart(FILE *fp)
{
  double mine[SUMS] = {sums_.friction, sums_.damping, sums_.work, sums_.rolling};
  memcpy(mine + 4, force_on_wall, sizeof force_on_wall);
  memcpy(mine + 7, torque_on_wall, sizeof torque_on_wall);
  mine[10] = sums_.conducted;
  double all[KEPT];
  wall.write(all + SUMS);
  MPI_Reduce(mine, all, SUMS, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  const int size = sizeof all;
  fwrite(&size, sizeof size, 1, fp);
  fwrite(all, sizeof(double), KEPT, fp);
}

void FixWallCarom::restart(char *buffer)
{
  const double *all = reinterpret_cast<double *>(buffer);
  if (!wall.is_shape(all + SUMS)) damaged("the wall has no shape");
  if (!wall.is_of(all + SUMS))
    error->all(FLERR, who() + ": the restart file has a " + carom::WallShape::name_of(all + SUMS) + " under this name, this run a " +
                          wall.name() + ": give the wall another name, or the shape of the file");
  if (!std::all_of(all, all + SUMS, [](double number) { return std::isfinite(number); }) || !wall.read(all + SUMS))
    damaged("the position or a sum of the wall is not a finite number");
  if (comm->me != 0) return;
  sums_ = {all[0], all[1], all[2], all[3], all[10]};
  memcpy(force_on_wall, all + 4, sizeof force_on_wall);
  memcpy(torque_on_wall, all + 7, sizeof torque_on_wall);
}

void FixWallCarom::grow_arrays(int nmax)
{
  contacts.resize(nmax);
}

// A grain moves to another index; what was stored there is no longer used.
void FixWallCarom::copy_arrays(int i, int j, int)
{
  std::swap(contacts[i], contacts[j]);
}

void FixWallCarom::drop_all(int i)
{
  for (Contact &contact : contacts[i]) contact.drop();
}

// A contact of a grain that is not in use, which may be new.
FixWallCarom::Contact &FixWallCarom::free_contact(int i)
{
  for (Contact &contact : contacts[i])
    if (!contact.is_in_use()) return contact;
  contacts[i].emplace_back();
  return contacts[i].back();
}

void FixWallCarom::set_arrays(int i)
{
  drop_all(i);
}

// The number of contacts, then for each the number of its values, and these.
int FixWallCarom::pack_exchange(int i, double *buffer)
{
  int count = 0, at = 1;
  for (Contact &contact : contacts[i]) {
    if (!contact.is_in_use()) continue;
    carom_error why;
    if (contact.pack(&why) != CAROM_STATUS_OK) carom::fail(lmp, who(), why);
    const int numbers = contact.count();
    buffer[at] = numbers + behind();
    std::copy_n(contact.numbers().data(), numbers, buffer + at + 1);
    memcpy(buffer + at + 1 + numbers, &contact.began, behind() * sizeof(double));
    at += 1 + numbers + behind();
    count++;
  }
  buffer[0] = count;
  return at;
}

int FixWallCarom::unpack_exchange(int i, double *buffer)
{
  drop_all(i);
  int at = 1;
  for (int k = 0; k < static_cast<int>(buffer[0]); k++) {
    const int numbers = static_cast<int>(buffer[at]) - behind();
    if (numbers < 1) damaged("a contact of grain " + std::to_string(atom->tag[i]) + " has too few values");
    Contact &contact = free_contact(i);
    contact.take(buffer + at + 1, numbers);
    memcpy(&contact.began, buffer + at + 1 + numbers, behind() * sizeof(double));
    at += 1 + numbers + behind();
  }
  return at;
}

int FixWallCarom::pack_restart(int i, double *buffer)
{
  buffer[0] = 1 + pack_exchange(i, buffer + 1);
  return static_cast<int>(buffer[0]);
}

void FixWallCarom::unpack_restart(int i, int nth)
{
  const int at = carom::wall_numbers::part_of(atom->extra[i], atom->nextra_store, nth);
  if (at < 0) damaged("the contacts of grain " + std::to_string(atom->tag[i]) + " have another number of values than stated");
  unpack_exchange(i, atom->extra[i] + at + 1);
}

void FixWallCarom::damaged(const std::string &what) const
{
  error->one(FLERR, who() + ": the restart file is damaged: " + what);
}

int FixWallCarom::size_restart(int i)
{
  int size = 2;
  for (const Contact &contact : contacts[i])
    if (contact.is_in_use()) size += 1 + contact.count() + behind();
  return size;
}

int FixWallCarom::maxsize_restart()
{
  return 2 + most_contacts() * (1 + carom::Touches::MOST + behind());
}

double FixWallCarom::memory_usage()
{
  double sum = wall.bytes() + static_cast<double>(contacts.capacity() * sizeof(contacts[0]));
  for (int i = 0; i < atom->nlocal; i++)
    for (const Contact &contact : contacts[i]) sum += contact.bytes();
  return sum;
}
