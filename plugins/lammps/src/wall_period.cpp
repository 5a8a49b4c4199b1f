// How a wall of triangles repeats itself in a periodic box.
#include "wall_shape.h"

#include "domain.h"
#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace carom {

static constexpr const char *AXES = "xyz";

static std::string number(double value)
{
  char text[40];
  snprintf(text, sizeof text, "%.10g", value);
  return text;
}

static std::string out_of_range(const std::string &field, const std::string &value, const std::string &allowed)
{
  return ": " + field + " = " + value + " is out of range: must be " + allowed;
}

static bool is_same(double one, double two)
{
  return std::fabs(one - two) <= 1e-12 * std::fabs(two);
}

// The periods of the box, 0 for none.
static void periods_of(LAMMPS *lmp, double *period)
{
  for (int axis = 0; axis < 3; axis++) period[axis] = lmp->domain->periodicity[axis] ? lmp->domain->prd[axis] : 0.0;
}

// The greatest tilt of an edge of the box, and its name.
static double tilt_of(const Domain *domain, int axis, const char **name)
{
  *name = axis == 1 ? "xy" : std::fabs(domain->xz) > std::fabs(domain->yz) ? "xz" : "yz";
  if (axis == 0 || !domain->triclinic) return 0.0;
  return axis == 1 ? domain->xy : (*name)[0] == 'x' ? domain->xz : domain->yz;
}

void WallShape::repeat(LAMMPS *lmp, const std::string &who)
{
  double period[3];
  periods_of(lmp, period);
  const int axes = static_cast<int>(std::count_if(period, period + 3, [](double length) { return length > 0.0; }));
  for (int axis = 0; axis < 3; axis++) {
    if (period[axis] == 0.0) continue;
    check_box(lmp, who, axis);
    check_turn(lmp, who, axis, axes);
  }
  if (has_periods_of(lmp)) return;
  make_mesh(lmp, who, period);
}

// The surface has the period of the box, which must be along an axis and stay.
void WallShape::check_box(LAMMPS *lmp, const std::string &who, int axis) const
{
  const Domain *domain = lmp->domain;
  const std::string along = std::string(" along ") + AXES[axis];
  const char *name;
  const double tilt = tilt_of(domain, axis, &name);
  if (tilt != 0.0)
    lmp->error->all(FLERR, who + out_of_range(std::string("tilt ") + name + " of the box", number(tilt), "0, since the box is periodic" + along));
  if (periods[axis] > 0.0 && !is_same(domain->prd[axis], periods[axis]))
    lmp->error->all(FLERR, who + out_of_range("length of the box" + along, number(domain->prd[axis]),
                                              number(periods[axis]) + " as in the run before, since the surface repeats itself there"));
  const int tilts[3] = {0, Fix::BOX_CHANGE_XY, Fix::BOX_CHANGE_XZ | Fix::BOX_CHANGE_YZ};
  for (const Fix *fix : lmp->modify->get_fix_list())
    if (fix->box_change & ((Fix::BOX_CHANGE_X << axis) | tilts[axis]))
      lmp->error->all(FLERR, who + ": fix " + fix->id + " " + fix->style + " changes the box" + along +
                                 ": must leave it as it is where it is periodic, since the surface repeats itself there");
}

// A surface that turns stays the same along the axis about which it does.
void WallShape::check_turn(LAMMPS *lmp, const std::string &who, int axis, int axes) const
{
  const std::string along = std::string("along ") + AXES[axis];
  for (int k = 0; k < 3; k++)
    if (k != axis && spin[k] != 0.0)
      lmp->error->all(FLERR, who + out_of_range("omega", number(spin[0]) + " " + number(spin[1]) + " " + number(spin[2]),
                                                axes == 1 ? along + ", in which the box is periodic"
                                                          : "0 0 0, since the box is periodic along more than one axis"));
  const double unit[3] = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
  double its[3];
  out_of_file(unit, its);
  const double off = std::hypot(its[(axis + 1) % 3], its[(axis + 2) % 3]);
  if (!(off <= 1e-9 && its[axis] > 0.0))
    lmp->error->all(FLERR, who + out_of_range(std::string("sine of the angle by which axis ") + AXES[axis] + " of the surface has turned",
                                              number(off), "0, since the box is periodic " + along));
}

bool WallShape::has_periods_of(LAMMPS *lmp) const
{
  double period[3];
  periods_of(lmp, period);
  for (int axis = 0; axis < 3; axis++) {
    const char *name;
    if (!is_same(period[axis], periods[axis])) return false;
    if (period[axis] > 0.0 && tilt_of(lmp->domain, axis, &name) != 0.0) return false;
  }
  return true;
}

// A surface that repeats itself is the same a period further: it is carried back, so that no digits are lost.
void WallShape::stay_close()
{
  for (int axis = 0; axis < 3; axis++) {
    const double period = periods[axis];
    if (period == 0.0) continue;
    const double far = std::trunc(point[axis] / period) * period;
    if (far == 0.0) continue;
    point[axis] -= far;
    middle[axis] -= far;
  }
}

}    // namespace carom
