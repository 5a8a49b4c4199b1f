#include "wall_shape.h"

#include "material.h"
#include "mesh_file.h"

#include "error.h"
#include "lammps.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace LAMMPS_NS;

namespace carom {

static double dot(const double *a, const double *b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double *a, const double *b, double *to)
{
  to[0] = a[1] * b[2] - a[2] * b[1];
  to[1] = a[2] * b[0] - a[0] * b[2];
  to[2] = a[0] * b[1] - a[1] * b[0];
}

// A unit vector across another one.
static void across(const double *direction, double *to)
{
  const double any[3] = {std::fabs(direction[0]) < 0.6 ? 1.0 : 0.0, std::fabs(direction[0]) < 0.6 ? 0.0 : 1.0, 0.0};
  const double along = dot(any, direction);
  for (int k = 0; k < 3; k++) to[k] = any[k] - along * direction[k];
  const double length = std::sqrt(dot(to, to));
  for (int k = 0; k < 3; k++) to[k] /= length;
}

static bool is_unit(const double *vector)
{
  return std::fabs(dot(vector, vector) - 1.0) < 1e-9;
}

// The keywords, how many words each requires, and these.
static constexpr struct {
  const char *name;
  int count;
  const char *words;
} KEYWORDS[] = {
    {"plane", 6, "six numbers: X Y Z NX NY NZ"},
    {"cylinder", 8, "seven numbers and a side: X Y Z DX DY DZ R inside, outside or both"},
    {"cone", 8, "seven numbers and a side: X Y Z DX DY DZ ANGLE inside, outside or both"},
    {"sphere", 5, "four numbers and a side: X Y Z R inside, outside or both"},
    {"between", 2, "two numbers"},
    {"velocity", 3, "three numbers"},
    {"omega", 3, "three numbers"},
    {"center", 3, "three numbers"},
    {"stl", 1, "a file"},
    {"scale", 1, "a number"},
    {"smooth", 1, "a number"},
    {"edges", 1, "a number"},
};

int WallShape::take(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  const std::string word = arg[0];
  const char *required = "";
  for (const auto &keyword : KEYWORDS) {
    if (word != keyword.name) continue;
    required = keyword.words;
    if (narg <= keyword.count) lmp->error->all(FLERR, who + ": " + word + " requires " + required);
  }
  const auto numbers = [&](int first, int count, double *to) {
    for (int k = 0; k < count; k++) {
      if (!utils::is_double(arg[first + k]))
        lmp->error->all(FLERR, who + ": " + word + " requires " + required + "; '" + arg[first + k] + "' is no number");
      to[k] = numeric(lmp, who, arg, first + k);
    }
  };
  if (word == "plane" && narg > 6) {
    set(lmp, who, PLANE);
    numbers(1, 3, point);
    numbers(4, 3, direction);
    return 7;
  }
  if ((word == "cylinder" || word == "cone") && narg > 8) {
    set(lmp, who, word == "cone" ? CONE : CYLINDER);
    numbers(1, 3, point);
    numbers(4, 3, direction);
    numbers(7, 1, &size);
    take_side(lmp, who, arg[8]);
    return 9;
  }
  if (word == "sphere" && narg > 5) {
    set(lmp, who, SPHERE);
    numbers(1, 3, point);
    numbers(4, 1, &size);
    take_side(lmp, who, arg[5]);
    return 6;
  }
  if (word == "between" && narg > 2) {
    numbers(1, 1, &from);
    numbers(2, 1, &to);
    is_bounded = true;
    return 3;
  }
  if (word == "velocity" && narg > 3) {
    numbers(1, 3, speed);
    return 4;
  }
  if (word == "omega" && narg > 3) {
    numbers(1, 3, spin);
    return 4;
  }
  if (word == "center" && narg > 3) {
    numbers(1, 3, middle);
    has_center = true;
    return 4;
  }
  if (word == "stl" && narg > 1) {
    set(lmp, who, MESH);
    file = arg[1];
    return 2;
  }
  return take_of_mesh(lmp, who, narg, arg);
}

int WallShape::take_of_mesh(LAMMPS *lmp, const std::string &who, int narg, char **arg)
{
  const std::string word = arg[0];
  if (narg < 2 || (word != "scale" && word != "smooth" && word != "edges")) return 0;
  double &value = word == "scale" ? scale : word == "smooth" ? smooth : edge_radius;
  value = numeric(lmp, who, arg, 1);
  has_edges = has_edges || word == "edges";
  is_for_mesh = true;
  return 2;
}

void WallShape::set(LAMMPS *lmp, const std::string &who, Kind shape)
{
  if (kind != NONE) lmp->error->all(FLERR, who + ": has more than one of plane, cylinder, cone, sphere and stl");
  kind = shape;
}

void WallShape::take_side(LAMMPS *lmp, const std::string &who, const std::string &word)
{
  if (word == "inside") side = INSIDE;
  else if (word == "outside") side = OUTSIDE;
  else if (word == "both") side = BOTH;
  else lmp->error->all(FLERR, who + ": after the radius or the angle comes the side of the grains: inside, outside or both, not '" + word + "'");
}

static std::string told(const char *field, double value, const char *allowed)
{
  char text[160];
  snprintf(text, sizeof text, ": %s = %g is out of range: must be %s", field, value, allowed);
  return text;
}

void WallShape::check(LAMMPS *lmp, const std::string &who)
{
  if (kind == NONE) lmp->error->all(FLERR, who + ": plane, cylinder, cone, sphere or stl is missing");
  if (kind == MESH) {
    check_mesh(lmp, who);
    return;
  }
  if (is_for_mesh) lmp->error->all(FLERR, who + ": scale, smooth and edges are for stl only");
  if (kind != SPHERE) {
    const double length = std::sqrt(dot(direction, direction));
    if (!(length > 0.0 && length < INFINITY))
      lmp->error->all(FLERR, who + (kind == PLANE ? ": the normal of the plane is zero" : ": the direction of the axis is zero"));
    for (double &number : direction) number /= length;
  }
  if ((kind == CYLINDER || kind == SPHERE) && !(size > 0.0 && size < INFINITY))
    lmp->error->all(FLERR, who + told(kind == SPHERE ? "radius of the sphere" : "radius of the cylinder", size, "finite and > 0"));
  if (kind == CONE) {
    if (!(size > 0.0 && size < 90.0))
      lmp->error->all(FLERR, who + told("angle of the cone", size, "in (0, 90) degrees"));
    const double radians = size * DEGREE;
    sine = std::sin(radians);
    cosine = std::cos(radians);
  }
  if (is_bounded) {
    if (kind != CYLINDER && kind != CONE) lmp->error->all(FLERR, who + ": between is for cylinder and cone only");
    if (!(from < to)) lmp->error->all(FLERR, who + told("second value of between", to, "above the first"));
    if (kind == CONE && !(from >= 0.0))
      lmp->error->all(FLERR, who + told("first value of between", from, "0 or more, from the apex of the cone"));
  } else {
    from = kind == CONE ? 0.0 : -std::numeric_limits<double>::infinity();
    to = std::numeric_limits<double>::infinity();
  }
  if (!has_center) std::copy_n(point, 3, middle);
}

void WallShape::check_mesh(LAMMPS *lmp, const std::string &who)
{
  if (is_bounded) lmp->error->all(FLERR, who + ": between is for cylinder and cone only");
  if (!(scale > 0.0 && scale < INFINITY)) lmp->error->all(FLERR, who + told("scale", scale, "finite and > 0"));
  if (!(smooth >= 1.0 && smooth <= 45.0)) lmp->error->all(FLERR, who + told("smooth", smooth, "from 1 to 45 degrees"));
  if (has_edges && !(edge_radius > 0.0 && edge_radius < INFINITY))
    lmp->error->all(FLERR, who + told("edges", edge_radius, "a radius, finite and > 0"));
  direction[2] = 1.0;
  if (!has_center) std::copy_n(point, 3, middle);
  triangles = triangles_of_file(lmp, who, file, scale);
  smooth_cosine = std::cos(smooth * DEGREE);
  make_mesh(lmp, who + ": STL file '" + file + "'", periods);
}

// All ranks have the same triangles.
void WallShape::make_mesh(LAMMPS *lmp, const std::string &who, const double *period)
{
  carom_mesh *made;
  carom_error why;
  if (carom_mesh_make(triangles.data(), triangles.size() / 9, smooth * DEGREE, period, &made, &why) != CAROM_STATUS_OK)
    lmp->error->all(FLERR, who + ": " + why.text);
  mesh.reset(made, carom_mesh_free);
  std::copy_n(period, 3, periods);
}

int WallShape::near(const double *x, double radius, Near *to, carom_error *why) const
{
  if (kind == MESH) return near_mesh(x, radius, to, why);
  to->is_refused = false;
  if (kind == PLANE) return near_plane(x, *to);
  return kind == SPHERE ? near_sphere(x, *to) : near_axis(x, radius, *to);
}

bool WallShape::is_turned() const
{
  return direction[2] != 1.0 || second[0] != 1.0;
}

// A vector in the axes of the file, and back.
void WallShape::into_file(const double *vector, double *to) const
{
  std::copy_n(vector, 3, to);
  if (!is_turned()) return;
  double third[3];
  cross(direction, second, third);
  to[0] = dot(vector, second);
  to[1] = dot(vector, third);
  to[2] = dot(vector, direction);
}

void WallShape::out_of_file(const double *vector, double *to) const
{
  std::copy_n(vector, 3, to);
  if (!is_turned()) return;
  double third[3];
  cross(direction, second, third);
  for (int k = 0; k < 3; k++) to[k] = vector[0] * second[k] + vector[1] * third[k] + vector[2] * direction[k];
}

// A little more than the radius, so that a contact that ends is seen to end.
static constexpr double REACH = 1.01;

int WallShape::near_mesh(const double *x, double radius, Near *to, carom_error *why) const
{
  const double arm[3] = {x[0] - point[0], x[1] - point[1], x[2] - point[2]};
  double own[3];
  into_file(arm, own);
  carom_place places[MOST];
  std::size_t count;
  if (carom_mesh_places(mesh.get(), own, REACH * radius, places, MOST, &count, why) != CAROM_STATUS_OK) return -1;
  const int most = static_cast<int>(std::min<std::size_t>(count, MOST + 1));
  for (int k = 0; k < std::min(most, MOST); k++) at_place(places[k], to[k]);
  return most;
}

void WallShape::at_place(const carom_place &place, Near &near) const
{
  // Of a face that does not turn any point of its plane will do.
  const bool is_at_rest = place.part == CAROM_PART_FACE && dot(spin, spin) == 0.0;
  const double *end = place.ends[0], *shift = place.shift;
  const double fixed[3] = {end[0] + shift[0], end[1] + shift[1], end[2] + shift[2]};
  out_of_file(is_at_rest ? fixed : place.point, near.place);
  for (int k = 0; k < 3; k++) near.place[k] += point[k];
  std::copy_n(place.normal, 3, near.own_normal);
  std::fill_n(near.own_axis, 3, 0.0);
  std::fill_n(near.curvature, 2, 0.0);
  near.height = place.distance;
  near.is_refused = place.is_sharp && edge_radius == 0.0;
  near.of_mesh = place;
  if (place.is_sharp && edge_radius > 0.0) {
    near.curvature[0] = 1.0 / edge_radius;
    if (place.part == CAROM_PART_CORNER) {
      near.curvature[1] = near.curvature[0];
    } else {
      double along[3] = {place.ends[1][0] - end[0], place.ends[1][1] - end[1], place.ends[1][2] - end[2]};
      const double length = std::sqrt(dot(along, along));
      for (double &number : along) number /= length;
      cross(along, place.normal, near.own_axis);
    }
  }
  out_of_file(near.own_normal, near.normal);
  out_of_file(near.own_axis, near.axis);
}

std::string WallShape::name_of(const Near &near)
{
  const double *one = near.of_mesh.ends[0], *two = near.of_mesh.ends[1];
  char text[240];
  if (near.of_mesh.part == CAROM_PART_CORNER)
    snprintf(text, sizeof text, "the corner at (%g, %g, %g)", one[0], one[1], one[2]);
  else
    snprintf(text, sizeof text, "the edge from (%g, %g, %g) to (%g, %g, %g)", one[0], one[1], one[2], two[0], two[1], two[2]);
  return text;
}

void WallShape::carry_axis(double *axis, Near &near) const
{
  const double along = dot(axis, near.own_normal);
  for (int k = 0; k < 3; k++) near.own_axis[k] = axis[k] - along * near.own_normal[k];
  const double length = std::sqrt(dot(near.own_axis, near.own_axis));
  if (length > 0.0)
    for (double &number : near.own_axis) number /= length;
  std::copy_n(near.own_axis, 3, axis);
  out_of_file(near.own_axis, near.axis);
}

bool WallShape::near_plane(const double *x, Near &near) const
{
  near.height = (x[0] - point[0]) * direction[0] + (x[1] - point[1]) * direction[1] + (x[2] - point[2]) * direction[2];
  const bool turns = dot(spin, spin) > 0.0;
  for (int k = 0; k < 3; k++) {
    // Of a plane that does not turn any point will do.
    near.place[k] = turns ? x[k] - near.height * direction[k] : point[k];
    near.normal[k] = direction[k];
    near.axis[k] = 0.0;
  }
  near.curvature[0] = near.curvature[1] = 0.0;
  return true;
}

bool WallShape::near_sphere(const double *x, Near &near) const
{
  double out[3] = {x[0] - point[0], x[1] - point[1], x[2] - point[2]};
  const double distance = std::sqrt(dot(out, out));
  for (int k = 0; k < 3; k++) out[k] = distance > 0.0 ? out[k] / distance : (k == 2 ? 1.0 : 0.0);
  const bool is_inside = side == INSIDE || (side == BOTH && distance < size);
  const double sign = is_inside ? -1.0 : 1.0;
  near.height = sign * (distance - size);
  for (int k = 0; k < 3; k++) {
    near.place[k] = point[k] + size * out[k];
    near.normal[k] = sign * out[k];
    near.axis[k] = 0.0;
  }
  near.curvature[0] = near.curvature[1] = sign / size;
  return true;
}

// Cylinder and cone, in the plane of axis and grain: `along` and `away` are the place of the grain there. A
// generator runs by (cosine, sine) from a point of the axis (cone) or at a distance from it (cylinder).
bool WallShape::near_axis(const double *x, double radius, Near &near) const
{
  double out[3] = {x[0] - point[0], x[1] - point[1], x[2] - point[2]};
  const double along = dot(out, direction);
  for (int k = 0; k < 3; k++) out[k] -= along * direction[k];
  const double away = std::sqrt(dot(out, out));
  if (away > 0.0)
    for (double &number : out) number /= away;
  else
    across(direction, out);
  const double base = kind == CYLINDER ? size : 0.0;
  const double outward = cosine * (away - base) - sine * along;
  const double foot = cosine * along + sine * (away - base);
  const double held = std::min(std::max(foot, from / cosine), to / cosine);
  const bool is_inside = side == INSIDE || (side == BOTH && outward < 0.0);
  const double sign = is_inside ? -1.0 : 1.0;
  const double at = cosine * held, distance = base + sine * held;
  double normal_along, normal_away;
  if (held == foot) {
    // Beyond its rims a grain can come to the other side of the wall.
    near.height = sign * outward;
    if (is_bounded && near.height < 0.0) return false;
    normal_along = -sign * sine;
    normal_away = sign * cosine;
  } else {
    normal_along = along - at;
    normal_away = away - distance;
    near.height = std::sqrt(normal_along * normal_along + normal_away * normal_away);
    if (near.height == 0.0) return false;
    normal_along /= near.height;
    normal_away /= near.height;
  }
  cross(direction, out, near.axis);
  for (int k = 0; k < 3; k++) {
    near.place[k] = point[k] + at * direction[k] + distance * out[k];
    near.normal[k] = normal_along * direction[k] + normal_away * out[k];
  }
  near.curvature[0] = sign * cosine / distance;
  near.curvature[1] = 0.0;
  // Of a cone in steps, so that contacts share their constants.
  constexpr double STEPS = 4096.0;
  if (kind == CONE) near.curvature[0] = std::round(STEPS * near.curvature[0] * radius) / (STEPS * radius);
  return true;
}

bool WallShape::turns_out_of(int axis) const
{
  for (int k = 0; k < 3; k++)
    if (k != axis && spin[k] != 0.0) return true;
  return false;
}

bool WallShape::extends_along(int axis) const
{
  if (kind == MESH) return true;
  if (turns_out_of(axis)) return false;
  if (kind == PLANE) return direction[axis] == 0.0;
  return kind == CYLINDER && !is_bounded && std::fabs(direction[axis]) == 1.0;
}

// A vector rotated by an angle about a unit vector.
static void rotate(const double *about, double angle, double *vector)
{
  double side[3];
  cross(about, vector, side);
  const double sine = std::sin(angle), half = std::sin(0.5 * angle), versine = 2.0 * half * half;
  const double along = dot(about, vector);
  for (int k = 0; k < 3; k++) vector[k] += sine * side[k] + versine * (along * about[k] - vector[k]);
}

void WallShape::move(double duration)
{
  for (int k = 0; k < 3; k++) {
    point[k] += duration * speed[k];
    middle[k] += duration * speed[k];
  }
  if (kind == MESH) stay_close();
  const double rate = std::sqrt(dot(spin, spin));
  if (rate == 0.0 || duration == 0.0) return;
  const double about[3] = {spin[0] / rate, spin[1] / rate, spin[2] / rate};
  double arm[3] = {point[0] - middle[0], point[1] - middle[1], point[2] - middle[2]};
  rotate(about, rate * duration, arm);
  for (int k = 0; k < 3; k++) point[k] = middle[k] + arm[k];
  if (kind == SPHERE) return;
  rotate(about, rate * duration, direction);
  const double length = std::sqrt(dot(direction, direction));
  for (double &number : direction) number /= length;
  if (kind != MESH) return;
  rotate(about, rate * duration, second);
  // Across the first, against round-off.
  const double along = dot(direction, second);
  for (int k = 0; k < 3; k++) second[k] -= along * direction[k];
  const double size = std::sqrt(dot(second, second));
  for (double &number : second) number /= size;
}

void WallShape::velocity_at(const double *place, const double *normal, const double *of_grain, double duration,
                            double *its) const
{
  double arm[3], whirl[3], moved[3];
  for (int k = 0; k < 3; k++) {
    arm[k] = place[k] - middle[k];
    moved[k] = of_grain[k] - speed[k];
  }
  cross(spin, arm, whirl);
  // Along the wall the place goes with the grain, along the normal with the wall.
  const double off = dot(whirl, normal) - dot(moved, normal);
  for (int k = 0; k < 3; k++) arm[k] -= 0.5 * duration * (moved[k] + off * normal[k]);
  cross(spin, arm, whirl);
  for (int k = 0; k < 3; k++) its[k] = speed[k] + whirl[k];
}

void WallShape::write(double *numbers) const
{
  std::copy_n(point, 3, numbers);
  std::copy_n(direction, 3, numbers + 3);
  std::copy_n(middle, 3, numbers + 6);
  std::copy_n(second, 3, numbers + 9);
  numbers[12] = kind;
}

bool WallShape::is_shape(const double *numbers)
{
  const double number = numbers[NUMBERS - 1];
  return number > NONE && number < KINDS && number == std::floor(number);
}

const char *WallShape::name_of(const double *numbers)
{
  return NAMES[static_cast<int>(numbers[NUMBERS - 1])];
}

bool WallShape::read(const double *numbers)
{
  if (!std::all_of(numbers, numbers + NUMBERS, [](double number) { return std::isfinite(number); })) return false;
  if (kind != SPHERE && !is_unit(numbers + 3)) return false;
  if (kind == MESH && !(is_unit(numbers + 9) && std::fabs(dot(numbers + 3, numbers + 9)) < 1e-9)) return false;
  std::copy_n(numbers, 3, point);
  std::copy_n(numbers + 3, 3, direction);
  std::copy_n(numbers + 6, 3, middle);
  std::copy_n(numbers + 9, 3, second);
  return true;
}

}    // namespace carom
