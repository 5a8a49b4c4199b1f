#include "seam.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace carom {

using Point = Seam::Point;

// The lowest coordinate along each axis.
static Point lowest(const std::vector<Point> &points)
{
  Point low = points.front();
  for (const Point &point : points)
    for (int axis = 0; axis < 3; axis++) low[axis] = std::min(low[axis], point[axis]);
  return low;
}

static double distance(const Point &one, const Point &two)
{
  double most = 0.0;
  for (int axis = 0; axis < 3; axis++) most = std::max(most, std::fabs(one[axis] - two[axis]));
  return most;
}

static int side_of(const Steps &steps)
{
  return 1 << (steps[0] + 2 * steps[1] + 4 * steps[2]);
}

namespace {

// Places on the low sides, in cells that are wider than the tolerance.
class Places {
 public:
  explicit Places(double tolerance) : tolerance(tolerance) {}

  // The nearest place within the tolerance that has no corner of this side yet, or else a new one.
  int place_of(const Point &point, int side)
  {
    const Cell middle = cell_of(point);
    int best = -1;
    double least = tolerance;
    for (int n = 0; n < 27; n++) {
      const auto found = cells.find({middle[0] + n % 3 - 1, middle[1] + n / 3 % 3 - 1, middle[2] + n / 9 - 1});
      if (found == cells.end()) continue;
      for (const int place : found->second) {
        const double off = distance(points[place], point);
        if ((sides[place] & side) != 0 || !(off <= least)) continue;
        least = off;
        best = place;
      }
    }
    if (best < 0) {
      best = static_cast<int>(points.size());
      cells[middle].push_back(best);
      points.push_back(point);
      sides.push_back(0);
    }
    sides[best] |= side;
    return best;
  }
  int count() const { return static_cast<int>(points.size()); }

 private:
  using Cell = std::array<long long, 3>;
  double tolerance;
  std::map<Cell, std::vector<int>> cells;
  std::vector<Point> points;
  std::vector<int> sides;    // of the corners there
  Cell cell_of(const Point &point) const
  {
    Cell cell;
    for (int axis = 0; axis < 3; axis++) cell[axis] = std::llround(std::floor(point[axis] / (4.0 * tolerance)));
    return cell;
  }
};

}    // namespace

// Corners on a high side are carried to the low one, where those that meet are one.
Seam::Seam(std::vector<Point> &points, const double *period, double tolerance)
    : firsts(points.size()), steps(points.size(), Steps{0, 0, 0})
{
  std::iota(firsts.begin(), firsts.end(), 0);
  const Point low = lowest(points);
  std::vector<int> rim;
  for (std::size_t n = 0; n < points.size(); n++) {
    bool is_low = false, is_high = false;
    for (int axis = 0; axis < 3; axis++) {
      if (period[axis] == 0.0) continue;
      const double off = points[n][axis] - low[axis];
      is_low = is_low || off <= 2.0 * tolerance;
      steps[n][axis] = off >= period[axis] - tolerance;
      is_high = is_high || steps[n][axis] != 0;
    }
    if (is_low || is_high) rim.push_back(static_cast<int>(n));
  }
  // Those on no high side first, so that they stay where they are.
  const auto sum = [&](int n) { return steps[n][0] + steps[n][1] + steps[n][2]; };
  std::stable_sort(rim.begin(), rim.end(), [&](int a, int b) { return sum(a) < sum(b); });
  Places places(tolerance);
  std::vector<std::vector<int>> all;
  for (const int n : rim) {
    Point carried = points[n];
    for (int axis = 0; axis < 3; axis++) carried[axis] -= steps[n][axis] * period[axis];
    const int place = places.place_of(carried, side_of(steps[n]));
    all.resize(places.count());
    all[place].push_back(n);
  }
  for (const std::vector<int> &group : all) {
    const int first = group.front();
    const Steps base = steps[first];
    for (const int n : group) {
      firsts[n] = first;
      for (int axis = 0; axis < 3; axis++) {
        steps[n][axis] -= base[axis];
        points[n][axis] = points[first][axis] + steps[n][axis] * period[axis];
      }
    }
    if (group.size() > 1) groups.push_back(group);
  }
}

Seam::Key Seam::key_of(int one, int two, Steps &away) const
{
  Steps across, back;
  for (int axis = 0; axis < 3; axis++) {
    across[axis] = steps[two][axis] - steps[one][axis];
    back[axis] = -across[axis];
  }
  const bool is_ahead = std::tie(firsts[one], back) <= std::tie(firsts[two], across);
  away = steps[is_ahead ? one : two];
  return is_ahead ? Key{firsts[one], firsts[two], across} : Key{firsts[two], firsts[one], back};
}

bool Seam::Key::operator<(const Key &other) const
{
  return std::tie(from, to, across) < std::tie(other.from, other.to, other.across);
}

}    // namespace carom
