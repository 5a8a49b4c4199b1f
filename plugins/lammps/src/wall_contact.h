// A contact of a grain with a wall: its touch while it is in work, its numbers while the host moves it.
#ifndef CAROM_WALL_CONTACT_H
#define CAROM_WALL_CONTACT_H

#include "carom.h"
#include "made_law.h"

#include <cstdint>
#include <vector>

namespace carom {

class WallContact {
 public:
  // How the wall was where the contact began.
  struct Began {
    double curvature[2];    // along the axis x of the contact and across it
    // Of a mesh, in the axes of its file, as they are now: by its normal a contact is known.
    double normal[3], axis[3];
  };
  Began began = {};

  bool is_in_use() const { return form != Form::NONE; }
  // The touch, unpacked if need be; new if there is none. Null if the numbers are not a contact: `why` says so.
  carom_touch *touch(const MadeLaw &its, double radius, carom_error *why);
  // Packs it; the numbers are then in `numbers()`.
  carom_status pack(carom_error *why);
  const std::vector<double> &numbers() const { return packed; }
  // How many numbers it packs into.
  int count() const;
  // Numbers that a file or another rank had.
  void take(const double *numbers, int count);
  void drop();
  double bytes() const { return sizeof *this + words.capacity() * sizeof(uint64_t) + packed.capacity() * sizeof(double); }

 private:
  enum class Form { NONE, PACKED, IN_WORK };
  Form form = Form::NONE;
  MadeLaw law;    // while it is in work
  std::vector<uint64_t> words;
  std::vector<double> packed;

  carom_touch *place() { return reinterpret_cast<carom_touch *>(words.data()); }
};

// How the contacts of a grain with a wall stand among numbers: how many there are, then for each the number of its
// values, and these.
namespace wall_numbers {
// A grain has at most so many contacts with one wall.
constexpr int MOST_CONTACTS = 16;
// No contact has more values than these.
constexpr int MOST = 1024;
// Index of the values of one fix among those that a restart file has for a grain. The first value of each part is
// its length. -1 if the values are not valid.
int part_of(const double *numbers, int count, int nth);
}    // namespace wall_numbers

}    // namespace carom

#endif
