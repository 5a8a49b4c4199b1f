#include "mesh_file.h"

#include "stl_file.h"

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "utils.h"

#include <exception>
#include <vector>

using namespace LAMMPS_NS;

namespace carom {

static std::vector<double> read(const std::string &path, std::string &fault)
{
  try {
    return read_stl(path);
  } catch (const std::exception &error) {
    fault = error.what();
    return {};
  }
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
  if (lmp->comm->me == 0)
    utils::logmesg(lmp, who + ": " + std::to_string(triangles.size() / 9) + " triangles from " + path + "\n");
  return triangles;
}

}    // namespace carom
