// The shape of a wall and its motion: where it is nearest to a grain, how it is curved there and how it moves.
#ifndef CAROM_WALL_SHAPE_H
#define CAROM_WALL_SHAPE_H

#include "carom.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace carom {

static constexpr double DEGREE = 3.14159265358979323846 / 180.0;    // in radians

// plane X Y Z NX NY NZ
// cylinder X Y Z DX DY DZ R side, cone X Y Z DX DY DZ ANGLE side, sphere X Y Z R side
// stl FILE, scale S, smooth ANGLE, edges R
// between A B, velocity VX VY VZ, omega WX WY WZ, center X Y Z
class WallShape {
 public:
  // Reads a keyword and its values; returns the number of words read, 0 for an unknown keyword.
  int take(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int narg, char **arg);
  // Raises an error for what is missing or does not fit together.
  void check(LAMMPS_NS::LAMMPS *lmp, const std::string &who);

  // Where it is nearest to a grain.
  struct Near {
    double place[3], normal[3];
    // Along the circumference of cylinder and cone; zero for the others, whose contacts are circles.
    double axis[3];
    double height;    // of the centre of the grain; negative behind the wall
    double curvature[2];    // along the axis and across it, of a sphere the same; negative where it is hollow
    // Of a mesh: normal and axis in the axes of its file, which turn with it, and whether it is an edge or corner that
    // no grain may touch.
    double own_normal[3], own_axis[3];
    bool is_refused;
    carom_place of_mesh;
  };
  // A mesh touches a grain in several places, the others in one.
  static constexpr int MOST = 16;
  // The places where a contact may be; returns their number, 0 if the wall has no side towards the grain, MOST + 1 if
  // there are more, -1 for a place of the grain at which there can be none: `why` says so.
  int near(const double *x, double radius, Near *to, carom_error *why) const;
  // A contact that comes from another place of a mesh keeps its axis, turned as the normal: `axis` is what it was, in
  // the axes of the file.
  void carry_axis(double *axis, Near &near) const;
  // The ends of an edge of a mesh, or the place of a corner, in words.
  static std::string name_of(const Near &near);

  bool is_curved() const { return kind != PLANE; }
  bool is_round() const { return kind == PLANE || kind == SPHERE || (is_mesh() && edge_radius == 0.0); }
  bool is_mesh() const { return kind == MESH; }
  // Contacts of a mesh whose normals differ by less are one: the cosine of the angle.
  double cosine_of_smooth() const { return smooth_cosine; }
  // The library needs 450 bytes a triangle.
  double bytes() const { return (8.0 + 450.0 / 9.0) * static_cast<double>(triangles.size()); }
  // Whether a box may be periodic along this axis: shape and motion are then the same all along it, or a mesh repeats
  // itself.
  bool extends_along(int axis) const;
  // Why it does not.
  const char *why_not_along(int axis) const { return turns_out_of(axis) ? "omega turns the wall away" : "the wall ends or is curved"; }
  // Makes the surface of a mesh, which repeats itself where the box is periodic. Raises an error if box, shape or motion
  // do not allow it.
  void repeat(LAMMPS_NS::LAMMPS *lmp, const std::string &who);
  // Whether the box still has the periods of the mesh.
  bool has_periods_of(LAMMPS_NS::LAMMPS *lmp) const;

  void move(double duration);
  // The velocity of the surface in the middle of a step, at whose end this place of it touches a grain. A step of the
  // contact adds what its depth below the surface makes, and the half of its growth.
  void velocity_at(const double *place, const double *normal, const double *of_grain, double duration, double *its) const;
  const double *velocity() const { return speed; }
  const double *omega() const { return spin; }
  const double *center() const { return middle; }

  // Position in a restart file: a point, two directions, the centre of rotation and the kind of shape.
  static constexpr int NUMBERS = 13;
  // Whether these numbers are of a wall of the same shape.
  static bool is_shape(const double *numbers);
  bool is_of(const double *numbers) const { return numbers[NUMBERS - 1] == kind; }
  const char *name() const { return NAMES[kind]; }
  static const char *name_of(const double *numbers);
  void write(double *numbers) const;
  // False if they are no position.
  bool read(const double *numbers);

 private:
  enum Kind { NONE, PLANE, CYLINDER, CONE, SPHERE, MESH, KINDS };
  static constexpr const char *NAMES[KINDS] = {"wall without shape", "plane", "cylinder", "cone", "sphere", "surface of triangles"};
  enum Side { INSIDE, OUTSIDE, BOTH };
  Kind kind = NONE;
  Side side = INSIDE;
  double point[3] = {0.0, 0.0, 0.0};
  double direction[3] = {0.0, 0.0, 0.0};    // normal of a plane, axis of cylinder and cone, axis z of a mesh
  double second[3] = {1.0, 0.0, 0.0};       // axis x of a mesh
  double size = 0.0;                        // a radius, of a cone half its angle
  double sine = 0.0, cosine = 1.0;          // of the latter
  double from, to;                          // along the axis
  bool is_bounded = false, has_center = false;
  std::string file;
  std::vector<double> triangles;    // of the file
  std::shared_ptr<carom_mesh> mesh;
  double periods[3] = {0.0, 0.0, 0.0};    // with which it repeats itself along the axes, 0 for none
  double scale = 1.0, smooth = 10.0, smooth_cosine, edge_radius = 0.0;    // no radius: edges are refused
  bool has_edges = false, is_for_mesh = false;    // whether a radius was given, or any of the three
  double speed[3] = {0.0, 0.0, 0.0}, spin[3] = {0.0, 0.0, 0.0}, middle[3] = {0.0, 0.0, 0.0};

  bool turns_out_of(int axis) const;
  void set(LAMMPS_NS::LAMMPS *lmp, const std::string &who, Kind shape);
  void take_side(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const std::string &word);
  int take_of_mesh(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int narg, char **arg);
  void check_mesh(LAMMPS_NS::LAMMPS *lmp, const std::string &who);
  void check_box(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int axis) const;
  void check_turn(LAMMPS_NS::LAMMPS *lmp, const std::string &who, int axis, int axes) const;
  void stay_close();
  bool is_turned() const;
  void into_file(const double *vector, double *to) const;
  void out_of_file(const double *vector, double *to) const;
  void make_mesh(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const double *period);
  int near_mesh(const double *x, double radius, Near *to, carom_error *why) const;
  void at_place(const carom_place &place, Near &near) const;
  bool near_plane(const double *x, Near &near) const;
  bool near_sphere(const double *x, Near &near) const;
  bool near_axis(const double *x, double radius, Near &near) const;
};

}    // namespace carom

#endif
