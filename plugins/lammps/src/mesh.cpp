#include "mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <utility>

namespace carom {

// Corners of triangles this far from a plane, over the size of the surface, lie in it: the round-off of the single
// precision of binary files.
static constexpr double FLATNESS = 2e-7;
// How far beyond its rim a face still counts, over the reach of a search, so that no ball falls between two triangles.
static constexpr double SLACK = 1e-9;

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

static void minus(const double *a, const double *b, double *to)
{
  for (int k = 0; k < 3; k++) to[k] = a[k] - b[k];
}

static double normalize(double *vector)
{
  const double length = std::sqrt(dot(vector, vector));
  for (int k = 0; k < 3; k++) vector[k] /= length;
  return length;
}

Mesh::Mesh(const std::vector<double> &triangles, double smooth, const double *period) : cosine(std::cos(smooth))
{
  std::copy_n(period, 3, periods);
  repeats = period[0] > 0.0 || period[1] > 0.0 || period[2] > 0.0;
  make_corners(triangles);
  tolerance = FLATNESS * size();
  if (repeats) {
    const Seam seam = close_corners();
    make_edges();
    close_edges(seam);
  } else {
    make_edges();
  }
  make_planes();
  make_inward();
  tell_sharp();
  make_cells();
  seen_faces.assign(faces.size(), 0);
  seen_edges.assign(edges.size(), 0);
  seen_corners.assign(corners.size(), 0);
}

// Corners with the same coordinates are one.
void Mesh::make_corners(const std::vector<double> &triangles)
{
  const std::size_t count = triangles.size() / 3;
  const auto place = [&](std::size_t n) {
    // The sum with zero makes -0 and 0 the same.
    return std::array<double, 3>{triangles[3 * n] + 0.0, triangles[3 * n + 1] + 0.0, triangles[3 * n + 2] + 0.0};
  };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  faces.resize(count / 3);
  for (std::size_t n = 0; n < count; n++) {
    const auto its = place(order[n]);
    if (n == 0 || its != place(order[n - 1])) {
      corners.emplace_back();
      std::copy_n(its.data(), 3, corners.back().at.at);
    }
    faces[order[n] / 3].corners[order[n] % 3] = static_cast<int>(corners.size()) - 1;
  }
}

double Mesh::size() const
{
  double most = 0.0;
  for (const Face &face : faces) {
    const double *first = corners[face.corners[0]].at.at;
    double one[3];
    minus(corners[face.corners[1]].at.at, first, one);
    for (int k = 0; k < 3; k++) most = std::max(most, std::max(std::fabs(one[k]), std::fabs(first[k])));
  }
  return most;
}

void Mesh::make_edges()
{
  std::map<std::pair<int, int>, int> known;
  for (Face &face : faces) {
    for (int k = 0; k < 3; k++) {
      const auto ends = std::minmax(face.corners[k], face.corners[(k + 1) % 3]);
      const auto found = known.emplace(std::make_pair(ends.first, ends.second), static_cast<int>(edges.size()));
      face.edges[k] = found.first->second;
      if (!found.second) continue;
      Edge edge = {{ends.first, ends.second}, {}, 0.0, true, false, {}, {}};
      minus(corners[ends.second].at.at, corners[ends.first].at.at, edge.along.at);
      edge.length = normalize(edge.along.at);
      Vector back;
      for (int axis = 0; axis < 3; axis++) back.at[axis] = -edge.along.at[axis];
      corners[ends.first].along.push_back(edge.along);
      corners[ends.second].along.push_back(back);
      edges.push_back(edge);
    }
  }
}

// Each triangle gets its plane; neighbours in it share the plane of the largest of them.
void Mesh::make_planes()
{
  std::vector<double> areas(faces.size());
  for (std::size_t n = 0; n < faces.size(); n++) {
    Face &face = faces[n];
    const double *first = corners[face.corners[0]].at.at;
    double one[3], two[3];
    minus(corners[face.corners[1]].at.at, first, one);
    minus(corners[face.corners[2]].at.at, first, two);
    cross(one, two, face.normal.at);
    areas[n] = normalize(face.normal.at);
    std::copy_n(first, 3, face.point.at);
  }
  std::vector<int> order(faces.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return areas[a] > areas[b]; });
  std::vector<char> done(faces.size(), 0);
  // Triangles by their edges.
  for (std::size_t n = 0; n < faces.size(); n++)
    for (const int edge : faces[n].edges) edges[edge].sides.push_back({static_cast<int>(n), edge});
  share(same_edges, edges, &Edge::sides);
  for (const int seed : order)
    if (!done[seed]) grow_plane(seed, done);
}

void Mesh::grow_plane(int seed, std::vector<char> &done)
{
  const Vector normal = faces[seed].normal;
  const auto lies_in_it = [&](const Face &face, const Vector &point) {
    for (const int corner : face.corners) {
      double arm[3];
      minus(corners[corner].at.at, point.at, arm);
      if (std::fabs(dot(arm, normal.at)) > tolerance) return false;
    }
    return true;
  };
  std::vector<int> left = {seed};
  done[seed] = 1;
  while (!left.empty()) {
    Face &face = faces[left.back()];
    left.pop_back();
    face.normal = normal;
    for (const int edge : face.edges)
      for (const Side &side : edges[edge].sides) {
        if (done[side.face]) continue;
        const Vector point = beyond(face.point, edge, side.edge);
        if (!lies_in_it(faces[side.face], point)) continue;
        faces[side.face].point = point;
        done[side.face] = 1;
        left.push_back(side.face);
      }
  }
}

void Mesh::make_inward()
{
  for (Face &face : faces) {
    for (int k = 0; k < 3; k++) {
      Edge &edge = edges[face.edges[k]];
      double *inward = face.inward[k].at, arm[3];
      cross(face.normal.at, edge.along.at, inward);
      normalize(inward);
      minus(corners[face.corners[(k + 2) % 3]].at.at, corners[face.corners[k]].at.at, arm);
      if (dot(arm, inward) < 0.0)
        for (int axis = 0; axis < 3; axis++) inward[axis] = -inward[axis];
      edge.inward.push_back(face.inward[k]);
    }
  }
  share(same_edges, edges, &Edge::inward);
}

void Mesh::tell_sharp()
{
  for (Edge &edge : edges) {
    const bool has_two = edge.inward.size() == 2;
    const double turn = has_two ? -dot(edge.inward[0].at, edge.inward[1].at) : -1.0;
    edge.is_sharp = !(turn >= cosine);
    const auto &one = faces[edge.sides.front().face].normal.at, &two = faces[edge.sides.back().face].normal.at;
    edge.is_flat = has_two && turn > 0.0 && std::equal(one, one + 3, two);
    for (const int end : edge.ends) corners[end].is_sharp = corners[end].is_sharp || edge.is_sharp;
  }
  for (const std::vector<int> &group : same_corners) {
    const bool is_sharp = std::any_of(group.begin(), group.end(), [&](int corner) { return corners[corner].is_sharp; });
    for (const int corner : group) corners[corner].is_sharp = is_sharp;
  }
}

void Mesh::begin_search() const
{
  close.clear();
  if (++search != 0) return;
  for (auto *seen : {&seen_faces, &seen_edges, &seen_corners}) std::fill(seen->begin(), seen->end(), 0u);
  search = 1;
}

void Mesh::try_face(int at, const double *center, double reach) const
{
  const Face &face = faces[at];
  double arm[3];
  minus(center, face.point.at, arm);
  const double height = dot(arm, face.normal.at);
  if (!(std::fabs(height) <= reach)) return;
  bool is_within = true;
  for (int k = 0; k < 3; k++) {
    minus(center, corners[face.corners[k]].at.at, arm);
    is_within = is_within && dot(arm, face.inward[k].at) >= -SLACK * reach;
    const int edge = face.edges[k], corner = face.corners[k];
    if (seen_edges[edge] != search && !edges[edge].is_flat) try_edge(edge, center, reach);
    if (seen_corners[corner] != search) try_corner(corner, center, reach);
    seen_edges[edge] = seen_corners[corner] = search;
  }
  if (!is_within) return;
  Place place = {};
  const double sign = height < 0.0 ? -1.0 : 1.0;
  for (int k = 0; k < 3; k++) {
    place.normal[k] = sign * face.normal.at[k];
    place.point[k] = center[k] - height * face.normal.at[k];
  }
  place.height = sign * height;
  place.fixed = face.point.at;
  place.kind = FACE;
  place.at = at;
  found.push_back(place);
}

void Mesh::try_edge(int at, const double *center, double reach) const
{
  const Edge &edge = edges[at];
  const double *end = corners[edge.ends[0]].at.at;
  double arm[3];
  minus(center, end, arm);
  const double foot = dot(arm, edge.along.at), slack = SLACK * reach;
  if (!(foot >= -slack && foot <= edge.length + slack)) return;
  for (int k = 0; k < 3; k++) arm[k] -= foot * edge.along.at[k];
  for (const Vector &inward : edge.inward)
    if (dot(arm, inward.at) > 0.0) return;
  const double height = std::sqrt(dot(arm, arm));
  if (!(height > 0.0 && height <= reach)) return;
  Place place = {};
  for (int k = 0; k < 3; k++) {
    place.normal[k] = arm[k] / height;
    place.point[k] = center[k] - arm[k];
    place.along[k] = edge.along.at[k];
  }
  place.height = height;
  place.fixed = end;
  place.kind = EDGE;
  place.at = at;
  place.is_sharp = edge.is_sharp;
  found.push_back(place);
}

void Mesh::try_corner(int at, const double *center, double reach) const
{
  const Corner &corner = corners[at];
  double arm[3];
  minus(center, corner.at.at, arm);
  const double height = std::sqrt(dot(arm, arm));
  if (!(height > 0.0 && height <= reach)) return;
  for (const Vector &along : corner.along)
    if (dot(arm, along.at) > 0.0) return;
  Place place = {};
  for (int k = 0; k < 3; k++) {
    place.normal[k] = arm[k] / height;
    place.point[k] = corner.at.at[k];
  }
  place.height = height;
  place.fixed = corner.at.at;
  place.kind = CORNER;
  place.at = at;
  place.is_sharp = corner.is_sharp;
  found.push_back(place);
}

int Mesh::places(const double *center, double reach, Place *to) const
{
  found.clear();
  if (repeats) find_in_all_periods(center, reach);
  else find_places(center, reach);
  return select(to, SLACK * reach);
}

void Mesh::find_places(const double *center, double reach) const
{
  begin_search();
  find_close(center, reach);
  for (const int face : close) try_face(face, center, reach);
}

// Of places whose normals nearly agree the nearest; at the same height faces are before edges, these before corners.
int Mesh::select(Place *to, double slack) const
{
  const auto is_before = [slack](const Place &one, const Place &two) {
    if (std::fabs(one.height - two.height) > slack) return one.height < two.height;
    return one.kind < two.kind;
  };
  int count = 0;
  while (!found.empty()) {
    if (count == MOST) return MOST + 1;
    auto best = found.begin();
    for (auto other = found.begin(); other != found.end(); ++other)
      if (is_before(*other, *best)) best = other;
    const Place chosen = *best;
    to[count++] = chosen;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const Place &place) { return dot(place.normal, chosen.normal) >= cosine; }),
                found.end());
  }
  // Faces first, as their triangles are in the file.
  std::sort(to, to + count, [](const Place &one, const Place &two) {
    return one.kind != two.kind ? one.kind < two.kind : one.at < two.at;
  });
  return count;
}

std::string Mesh::name_of(const Place &place) const
{
  char text[240];
  if (place.kind == EDGE) {
    const double *one = corners[edges[place.at].ends[0]].at.at, *two = corners[edges[place.at].ends[1]].at.at;
    snprintf(text, sizeof text, "the edge from (%g, %g, %g) to (%g, %g, %g)", one[0], one[1], one[2], two[0], two[1], two[2]);
  } else {
    const double *at = place.kind == CORNER ? corners[place.at].at.at : place.point;
    snprintf(text, sizeof text, "the %s at (%g, %g, %g)", place.kind == CORNER ? "corner" : "face", at[0], at[1], at[2]);
  }
  return text;
}

double Mesh::bytes() const
{
  const std::size_t all = faces.capacity() * (sizeof(Face) + sizeof(unsigned)) +
      edges.capacity() * (sizeof(Edge) + sizeof(unsigned) + 2 * sizeof(Vector) + 2 * sizeof(Side)) +
      corners.capacity() * (sizeof(Corner) + sizeof(unsigned) + 6 * sizeof(Vector)) +
      (starts.capacity() + listed.capacity()) * sizeof(int);
  return static_cast<double>(all);
}

}    // namespace carom
