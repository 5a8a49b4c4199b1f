// The shape of a wall and its motion: where it is nearest to a grain, how it is curved there and how it moves.
#ifndef CAROM_WALL_SHAPE_H
#define CAROM_WALL_SHAPE_H

#include "carom.h"

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace carom {

// plane X Y Z NX NY NZ
// cylinder X Y Z DX DY DZ R side, cone X Y Z DX DY DZ ANGLE side, sphere X Y Z R side
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
    double curvature;    // along the axis, of a sphere in all directions; negative where it is hollow
  };
  // False if the wall has no side towards the grain.
  bool near(const double *x, double radius, Near &near) const;

  bool is_curved() const { return kind != PLANE; }
  bool is_round() const { return kind == PLANE || kind == SPHERE; }
  // Whether a box may be periodic along this axis: shape and motion are then the same all along it.
  bool extends_along(int axis) const;

  void move(double duration);
  // The velocity in the middle of a step, at whose end this place of the wall touches a grain.
  void velocity_at(const double *place, const double *of_grain, double duration, double *its) const;
  const double *velocity() const { return speed; }
  const double *omega() const { return spin; }
  const double *center() const { return middle; }

  // Position in a restart file: a point, a direction and the centre of rotation.
  static constexpr int NUMBERS = 9;
  void write(double *numbers) const;
  // False if they are no position.
  bool read(const double *numbers);

 private:
  enum Kind { NONE, PLANE, CYLINDER, CONE, SPHERE };
  enum Side { INSIDE, OUTSIDE, BOTH };
  Kind kind = NONE;
  Side side = INSIDE;
  double point[3] = {0.0, 0.0, 0.0};
  double direction[3] = {0.0, 0.0, 0.0};    // normal of a plane, axis of cylinder and cone
  double size = 0.0;                        // a radius, of a cone half its angle
  double sine = 0.0, cosine = 1.0;          // of the latter
  double from, to;                          // along the axis
  bool is_bounded = false, has_center = false;
  double speed[3] = {0.0, 0.0, 0.0}, spin[3] = {0.0, 0.0, 0.0}, middle[3] = {0.0, 0.0, 0.0};

  void set(LAMMPS_NS::LAMMPS *lmp, const std::string &who, Kind shape);
  void take_side(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const std::string &word);
  bool near_plane(const double *x, Near &near) const;
  bool near_sphere(const double *x, Near &near) const;
  bool near_axis(const double *x, double radius, Near &near) const;
};

}    // namespace carom

#endif
