// Cells of a box about the surface, each with the triangles that come near it.
#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carom {

// Cells for each triangle.
static constexpr double CELLS = 2.0;

void Mesh::make_cells()
{
  for (int axis = 0; axis < 3; axis++) {
    const auto less = [axis](const Corner &a, const Corner &b) { return a.at.at[axis] < b.at.at[axis]; };
    const auto ends = std::minmax_element(corners.begin(), corners.end(), less);
    low[axis] = ends.first->at.at[axis];
    high[axis] = ends.second->at.at[axis];
  }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  // Cells are cubes, but that a surface in a plane has a single layer.
  double volume = 1.0;
  for (int axis = 0; axis < 3; axis++) volume *= std::max((high[axis] - low[axis]) / size, 1e-2);
  const double edge = size * std::cbrt(volume / (CELLS * static_cast<double>(faces.size()) + 8.0));
  for (int axis = 0; axis < 3; axis++) {
    const double most = 1000.0;
    counts[axis] = static_cast<int>(std::min(std::max(std::ceil((high[axis] - low[axis]) / edge), 1.0), most));
    width[axis] = std::max((high[axis] - low[axis]) / counts[axis], 1e-12 * size);
  }
  starts.assign(static_cast<std::size_t>(counts[0]) * counts[1] * counts[2] + 1, 0);
  // Counts first, then places.
  const auto each = [&](const auto &take) {
    for (std::size_t n = 0; n < faces.size(); n++) {
      double from[3], to[3];
      for (int axis = 0; axis < 3; axis++) {
        const auto at = [&](int k) { return corners[faces[n].corners[k]].at.at[axis]; };
        from[axis] = std::min({at(0), at(1), at(2)});
        to[axis] = std::max({at(0), at(1), at(2)});
      }
      int first[3], last[3], cell[3];
      cells_of(from, to, first, last);
      for (cell[2] = first[2]; cell[2] <= last[2]; cell[2]++)
        for (cell[1] = first[1]; cell[1] <= last[1]; cell[1]++)
          for (cell[0] = first[0]; cell[0] <= last[0]; cell[0]++)
            if (comes_near(faces[n], cell)) take((cell[2] * static_cast<std::size_t>(counts[1]) + cell[1]) * counts[0] + cell[0], n);
    }
  };
  each([&](std::size_t cell, std::size_t) { starts[cell + 1]++; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  listed.resize(starts.back());
  std::vector<int> next(starts.begin(), starts.end() - 1);
  each([&](std::size_t cell, std::size_t n) { listed[next[cell]++] = static_cast<int>(n); });
}

// Whether the plane of a triangle comes near a cell.
bool Mesh::comes_near(const Face &face, const int *cell) const
{
  double height = 0.0, reach = 0.0;
  for (int axis = 0; axis < 3; axis++) {
    const double middle = low[axis] + (cell[axis] + 0.5) * width[axis];
    height += (middle - face.point.at[axis]) * face.normal.at[axis];
    reach += 0.5 * width[axis] * std::fabs(face.normal.at[axis]);
  }
  // A little more, for what lies on the border of two cells.
  return std::fabs(height) <= 1.01 * reach + 0.01 * std::max({width[0], width[1], width[2]});
}

void Mesh::cells_of(const double *from, const double *to, int *first, int *last) const
{
  for (int axis = 0; axis < 3; axis++) {
    const double end = counts[axis] - 1.0;
    first[axis] = static_cast<int>(std::min(std::max(std::floor((from[axis] - low[axis]) / width[axis]), 0.0), end));
    last[axis] = static_cast<int>(std::min(std::max(std::floor((to[axis] - low[axis]) / width[axis]), 0.0), end));
  }
}

// The triangles of the cells that a ball reaches, in their order.
void Mesh::find_close(const double *center, double reach) const
{
  double from[3], to[3];
  for (int axis = 0; axis < 3; axis++) {
    from[axis] = center[axis] - reach;
    to[axis] = center[axis] + reach;
    if (!(to[axis] >= low[axis] && from[axis] <= high[axis])) return;
  }
  int first[3], last[3];
  cells_of(from, to, first, last);
  for (int z = first[2]; z <= last[2]; z++)
    for (int y = first[1]; y <= last[1]; y++) {
      const std::size_t row = (z * static_cast<std::size_t>(counts[1]) + y) * counts[0];
      for (int k = starts[row + first[0]]; k < starts[row + last[0] + 1]; k++) {
        const int face = listed[k];
        if (seen_faces[face] == search) continue;
        seen_faces[face] = search;
        close.push_back(face);
      }
    }
  std::sort(close.begin(), close.end());
}

}    // namespace carom
