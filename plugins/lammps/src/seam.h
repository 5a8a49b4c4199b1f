// Which corners of a surface are one where it repeats itself.
#ifndef CAROM_SEAM_H
#define CAROM_SEAM_H

#include <array>
#include <vector>

namespace carom {

// Along each axis a number of periods.
using Steps = std::array<int, 3>;

// Corners that coincide modulo the periods, as those at two opposite sides of a surface that is as long as its period.
class Seam {
 public:
  using Point = std::array<double, 3>;
  // The periods along the axes are 0 where the surface does not repeat itself. Corners that are one within `tolerance`
  // are moved by less than that, so that they are one exactly.
  Seam(std::vector<Point> &points, const double *period, double tolerance);

  // The corners that are one, without those that are alone.
  std::vector<std::vector<int>> groups;
  // Of a corner: the first of its group, or itself, and how far from there.
  int first_of(int corner) const { return firsts[corner]; }
  const Steps &steps_of(int corner) const { return steps[corner]; }

  // An edge from a corner to another modulo the periods: equal for edges that are one.
  struct Key {
    int from, to;
    Steps across;
    bool operator<(const Key &other) const;
  };
  // The key of an edge, and how many periods it is away from others with this key.
  Key key_of(int one, int two, Steps &away) const;

 private:
  std::vector<int> firsts;
  std::vector<Steps> steps;
};

// What is a list of each member becomes that of all.
template <class Part, class Item>
void share(const std::vector<std::vector<int>> &groups, std::vector<Part> &parts, std::vector<Item> Part::*list)
{
  for (const std::vector<int> &group : groups) {
    std::vector<Item> all;
    for (const int member : group) all.insert(all.end(), (parts[member].*list).begin(), (parts[member].*list).end());
    for (const int member : group) parts[member].*list = all;
  }
}

}    // namespace carom

#endif
