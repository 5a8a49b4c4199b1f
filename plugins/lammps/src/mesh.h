// A surface of triangles: where it is nearest to a ball.
#ifndef CAROM_MESH_H
#define CAROM_MESH_H

#include "seam.h"

#include <cstddef>
#include <string>
#include <vector>

namespace carom {

// A ball touches the surface where its centre is nearer to it than anywhere close by: within a face, on an edge or at
// a corner. Triangles in one plane are one face. Both sides of a triangle count. Places whose normals differ by less
// than an angle are one place, the nearest of them, so that a ball rolls over the edges of a finely triangulated
// surface with one contact. A surface may repeat itself along axes; where it leaves one period and enters the next its
// corners and edges are shared as elsewhere.
class Mesh {
 public:
  // Nine numbers for each triangle, this angle in radians, and for each axis the period, 0 if there is none.
  Mesh(const std::vector<double> &triangles, double smooth, const double *period);

  enum Kind { FACE, EDGE, CORNER };
  struct Place {
    double point[3], normal[3];    // the normal points to the centre of the ball
    const double *fixed;           // a point of the plane or edge that stays where it is, or the corner
    double along[3];               // of an edge
    double height;                 // of the centre
    Kind kind;
    int at;          // which one: of a face a triangle
    bool is_sharp;    // an edge or a corner where triangles meet at more than the angle, or end
    int period;       // of a surface that repeats itself: where among the periods of the last search
  };
  // A ball touches in at most so many places.
  static constexpr int MOST = 16;
  // The places whose height is at most `reach`, in the order of the triangles; returns their number, MOST + 1 if there
  // are more.
  int places(const double *center, double reach, Place *to) const;

  // The ends of an edge, or the place of a corner, in words.
  std::string name_of(const Place &place) const;
  bool does_repeat() const { return repeats; }
  // The fixed point of a place of the last search, in its period.
  void fixed_in_period(const Place &place, double *to) const;
  double cosine_of_smooth() const { return cosine; }
  const double *period() const { return periods; }
  // Whether it is longer along an axis than it may be.
  bool is_too_long(int axis) const { return periods[axis] > 0.0 && length(axis) > periods[axis] + tolerance; }
  double length(int axis) const { return high[axis] - low[axis]; }
  double bytes() const;

 private:
  struct Vector {
    double at[3];
  };
  struct Face {
    int corners[3], edges[3];    // edge k runs from corner k to the next
    Vector inward[3];            // from edge k, in the plane of the face
    Vector normal, point;        // shared by all triangles of a plane
  };
  // A triangle, and which of its edges is meant.
  struct Side {
    int face, edge;
  };
  struct Edge {
    int ends[2];
    Vector along;
    double length;
    bool is_sharp, is_flat;
    std::vector<Vector> inward;    // into each of its triangles
    std::vector<Side> sides;       // these triangles
  };
  struct Corner {
    Vector at;
    bool is_sharp = false;
    std::vector<Vector> along;    // its edges, away from it
  };
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Corner> corners;
  double cosine, tolerance, periods[3];
  bool repeats;
  // Corners and edges that are one modulo the periods.
  std::vector<std::vector<int>> same_corners, same_edges;
  std::vector<Steps> away;    // by edge: in periods, from those with which it is one

  void make_corners(const std::vector<double> &triangles);
  double size() const;
  Seam close_corners();
  void close_edges(const Seam &seam);
  void make_edges();
  void make_planes();
  void grow_plane(int seed, std::vector<char> &done);
  Vector beyond(const Vector &point, int from, int to) const;
  void make_inward();
  void tell_sharp();

  // Cells of a box about the surface; each lists the triangles that come near it.
  double low[3], high[3], width[3];
  int counts[3];
  std::vector<int> starts, listed;
  void make_cells();
  void cells_of(const double *from, const double *to, int *first, int *last) const;
  bool comes_near(const Face &face, const int *cell) const;

  // Work of one search; what was seen in it has its number.
  mutable std::vector<unsigned> seen_faces, seen_edges, seen_corners;
  mutable unsigned search = 0;
  mutable std::vector<int> close;
  mutable std::vector<Place> found;
  mutable std::vector<Vector> shifts;    // of the periods that the ball reaches
  void begin_search() const;
  void find_places(const double *center, double reach) const;
  void find_in_all_periods(const double *center, double reach) const;
  void find_in_period(const Vector &shift, const double *center, double reach) const;
  void find_close(const double *center, double reach) const;
  void try_face(int face, const double *center, double reach) const;
  void try_edge(int edge, const double *center, double reach) const;
  void try_corner(int corner, const double *center, double reach) const;
  int select(Place *to, double slack) const;
};

}    // namespace carom

#endif
