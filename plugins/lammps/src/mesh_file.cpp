#include "mesh_file.h"

#include "stl_file.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "utils.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <vector>

using namespace LAMMPS_NS;

namespace carom {

// A surface so many times as long as the box is warned of.
static constexpr double UNUSUAL = 100.0;

static std::vector<double> read(const std::string &path, std::string &fault)
{
  try {
    return read_stl(path);
  } catch (const std::exception &error) {
    fault = error.what();
    return {};
  }
}

// How many triangles there are and how far they reach: a file in mm gives a surface a thousand times as large as the box.
static void tell(LAMMPS *lmp, const std::string &what, const std::vector<double> &triangles)
{
  if (lmp->comm->me != 0) return;
  double low[3], high[3];
  std::copy_n(triangles.begin(), 3, low);
  std::copy_n(triangles.begin(), 3, high);
  for (std::size_t k = 0; k < triangles.size(); k++) {
    low[k % 3] = std::min(low[k % 3], triangles[k]);
    high[k % 3] = std::max(high[k % 3], triangles[k]);
  }
  char reach[160];
  snprintf(reach, sizeof reach, ", from (%g %g %g) to (%g %g %g)", low[0], low[1], low[2], high[0], high[1], high[2]);
  utils::logmesg(lmp, what + reach + "\n");
  double longest = 0.0, box = 0.0;
  for (int k = 0; k < 3; k++) {
    longest = std::max(longest, high[k] - low[k]);
    box = std::max(box, lmp->domain->boxhi[k] - lmp->domain->boxlo[k]);
  }
  if (longest > UNUSUAL * box)
    lmp->error->warning(FLERR, what + reach + ": far beyond the box: is the file in another unit, as with scale 0.001?");
}

std::vector<double> triangles_of_file(LAMMPS *lmp, const std::string &who, const std::string &path, double scale)
{
  std::vector<double> triangles;
  std::string fault;
  if (lmp->comm->me == 0) triangles = read(path, fault);
  int sizes[2] = {static_cast<int>(triangles.size()), static_cast<int>(fault.size())};
  MPI_Bcast(sizes, 2, MPI_INT, 0, lmp->world);
  triangles.resize(sizes[0]);
  fault.resize(sizes[1]);
  MPI_Bcast(&fault[0], sizes[1], MPI_CHAR, 0, lmp->world);
  if (!fault.empty()) lmp->error->all(FLERR, who + ": " + fault);
  MPI_Bcast(triangles.data(), sizes[0], MPI_DOUBLE, 0, lmp->world);
  for (double &number : triangles) number *= scale;
  tell(lmp, who + ": " + std::to_string(triangles.size() / 9) + " triangles from " + path, triangles);
  return triangles;
}

}    // namespace carom
