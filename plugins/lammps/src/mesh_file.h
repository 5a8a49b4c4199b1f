// The triangles of an STL file, on all ranks.
#ifndef CAROM_MESH_FILE_H
#define CAROM_MESH_FILE_H

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace carom {

// The first rank reads the file, the others get its triangles from it. Coordinates are multiplied by `scale`. Raises
// an error of the host on all ranks.
std::vector<double> triangles_of_file(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const std::string &path,
                                      double scale);

}    // namespace carom

#endif
