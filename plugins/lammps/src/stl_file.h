// Reads the triangles of an STL file, text or binary.
#ifndef CAROM_STL_FILE_H
#define CAROM_STL_FILE_H

#include <string>
#include <vector>

namespace carom {

// Nine numbers for each triangle, its three corners, as they stand there. The normals of the file are left out. Throws a
// std::runtime_error that names the file, the triangle and what is allowed.
std::vector<double> read_stl(const std::string &path);

}    // namespace carom

#endif
