// The surface of an STL file, on all ranks.
#ifndef CAROM_MESH_FILE_H
#define CAROM_MESH_FILE_H

#include "mesh.h"

#include <memory>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace carom {

// The first rank reads the file, the others get its triangles from it. Coordinates are multiplied by `scale`; the angle
// `smooth` is in radians. Raises an error of the host on all ranks.
std::shared_ptr<const Mesh> mesh_of_file(LAMMPS_NS::LAMMPS *lmp, const std::string &who, const std::string &path,
                                         double scale, double smooth);

}    // namespace carom

#endif
