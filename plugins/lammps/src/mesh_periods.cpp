// A surface that repeats itself: its corners and edges at the seams, and the search in all periods that a ball reaches.
#include "mesh.h"

#include <cmath>
#include <map>

namespace carom {

// Corners that are one are brought together and share their edges.
Seam Mesh::close_corners()
{
  std::vector<Seam::Point> points(corners.size());
  for (std::size_t n = 0; n < corners.size(); n++)
    for (int axis = 0; axis < 3; axis++) points[n][axis] = corners[n].at.at[axis];
  Seam seam(points, periods, tolerance);
  for (std::size_t n = 0; n < corners.size(); n++)
    for (int axis = 0; axis < 3; axis++) corners[n].at.at[axis] = points[n][axis];
  same_corners = seam.groups;
  return seam;
}

// Edges whose ends are one.
void Mesh::close_edges(const Seam &seam)
{
  std::map<Seam::Key, std::vector<int>> known;
  std::vector<char> is_shared(corners.size(), 0);
  for (const std::vector<int> &group : same_corners)
    for (const int corner : group) is_shared[corner] = 1;
  away.assign(edges.size(), Steps{0, 0, 0});
  for (std::size_t n = 0; n < edges.size(); n++) {
    const int *ends = edges[n].ends;
    if (!is_shared[ends[0]] || !is_shared[ends[1]]) continue;
    known[seam.key_of(ends[0], ends[1], away[n])].push_back(static_cast<int>(n));
  }
  for (const auto &one : known)
    if (one.second.size() > 1) same_edges.push_back(one.second);
  share(same_corners, corners, &Corner::along);
}

// A point as it is seen from another of the edges that are one.
Mesh::Vector Mesh::beyond(const Vector &point, int from, int to) const
{
  if (from == to) return point;
  Vector moved;
  for (int axis = 0; axis < 3; axis++)
    moved.at[axis] = point.at[axis] + (away[to][axis] - away[from][axis]) * periods[axis];
  return moved;
}

// Where the surface is the same as a period further, the ball is carried there and the places back.
void Mesh::find_in_all_periods(const double *center, double reach) const
{
  double first[3] = {0.0, 0.0, 0.0}, last[3] = {0.0, 0.0, 0.0}, at[3];
  for (int axis = 0; axis < 3; axis++) {
    if (!std::isfinite(center[axis])) return;
    if (periods[axis] == 0.0) continue;
    first[axis] = std::ceil((center[axis] - reach - high[axis]) / periods[axis]);
    last[axis] = std::floor((center[axis] + reach - low[axis]) / periods[axis]);
  }
  shifts.clear();
  for (at[2] = first[2]; at[2] <= last[2]; at[2]++)
    for (at[1] = first[1]; at[1] <= last[1]; at[1]++)
      for (at[0] = first[0]; at[0] <= last[0]; at[0]++) {
        Vector shift;
        for (int axis = 0; axis < 3; axis++) shift.at[axis] = at[axis] * periods[axis];
        find_in_period(shift, center, reach);
      }
}

void Mesh::find_in_period(const Vector &shift, const double *center, double reach) const
{
  double carried[3];
  for (int axis = 0; axis < 3; axis++) carried[axis] = center[axis] - shift.at[axis];
  const std::size_t known = found.size();
  find_places(carried, reach);
  for (std::size_t n = known; n < found.size(); n++) {
    for (int axis = 0; axis < 3; axis++) found[n].point[axis] += shift.at[axis];
    found[n].period = static_cast<int>(shifts.size());
  }
  shifts.push_back(shift);
}

void Mesh::fixed_in_period(const Place &place, double *to) const
{
  for (int axis = 0; axis < 3; axis++) to[axis] = place.fixed[axis] + shifts[place.period].at[axis];
}

}    // namespace carom
