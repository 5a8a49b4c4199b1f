// The contacts of one rank while it runs: kept as numbers in slots of the host's, which it moves from
// rank to rank and into restart files, and unpacked here between two such moves.
#ifndef CAROM_TOUCHES_H
#define CAROM_TOUCHES_H

#include "carom.h"

#include <vector>

namespace carom {

// The first number of a slot is zero where nothing touches, positive where the slot holds a packed
// contact, and -1 - index where contact `index` is unpacked.
class Touches {
 public:
  static constexpr int NUMBERS = CAROM_TOUCH_NUMBERS;
  // A slot with a twist: its numbers stand behind those of the contact and stay there.
  static constexpr int WITH_TWIST = NUMBERS + CAROM_TWIST_NUMBERS;
  static carom_twist *twist_of(double *slot) { return reinterpret_cast<carom_twist *>(slot + NUMBERS); }

  // The contact of a slot, unpacked; made if there is none. Null if the numbers are no contact: `why` says so.
  carom_touch *at(double *slot, const carom_grains &grains, double radius_1, double radius_2,
                  carom_error *why)
  {
    if (slot[0] < 0.0) return &pool[index(slot)];
    return unpack(slot, grains, radius_1, radius_2, why);
  }
  static bool is_unpacked(const double *slot) { return slot[0] < 0.0; }
  // The contact of a slot that is unpacked.
  carom_touch &of(const double *slot) { return pool[index(slot)]; }

  // The host's flag of a pair of grains: 0 apart, 1 in contact, above that it says where what is unpacked
  // is, without a look at the slot.
  static int flag_of(const double *slot) { return is_unpacked(slot) ? 2 + index(slot) : 1; }
  carom_touch *with_flag(int flag) { return flag > 1 ? &pool[flag - 2] : nullptr; }
  // Ends the contact of a slot; its twist is left to the caller.
  void drop(double *slot);
  // Makes a slot hold its contact as numbers.
  carom_status pack(double *slot, carom_error *why);
  double bytes() const { return static_cast<double>(pool.capacity() * sizeof(carom_touch)); }

 private:
  std::vector<carom_touch> pool;
  std::vector<int> unused;

  static int index(const double *slot) { return static_cast<int>(-1.0 - slot[0]); }
  carom_touch *unpack(double *slot, const carom_grains &grains, double radius_1, double radius_2,
                      carom_error *why);
};

}    // namespace carom

#endif
