// The contacts of grains of one rank during a run: stored as numbers in slots of the host, which moves them between
// ranks and into restart files, and unpacked here between two such moves.
#ifndef CAROM_TOUCHES_H
#define CAROM_TOUCHES_H

#include "carom.h"
#include "made_law.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom {

// The first number of a slot is zero without contact, positive if the slot holds a packed contact, and -1 -
// index if contact `index` is unpacked. Since a slot may come from a damaged restart file, an index is
// accepted only if the contact was unpacked here.
class Touches {
 public:
  // No law packs a contact into more numbers.
  static constexpr int MOST = 512;
  // The heat that a contact made in the last step, and since it began: at the end of its slot.
  static constexpr int HEATS = 2;

  // Makes place for touches of a law.
  void fit(const MadeLaw &law);
  // The unpacked contact of a slot; new if there is none. Null if the numbers are not a contact: `why` says so.
  carom_touch *at(double *slot, const MadeLaw &law, double radius_1, double radius_2, carom_error *why)
  {
    if (!is_unpacked(slot)) return unpack(slot, law, radius_1, radius_2, why);
    const int place = index(slot);
    if (place >= 0) return touch(place);
    strange(slot, why);
    return nullptr;
  }
  static bool is_unpacked(const double *slot) { return slot[0] < 0.0; }

  // The host's flag of a pair of grains: 0 separated, 1 in contact; larger values give the index of the
  // unpacked contact without reading the slot.
  int flag_of(const double *slot) const { return is_unpacked(slot) ? 2 + index(slot) : 1; }
  carom_touch *with_flag(int flag) { return flag > 1 ? touch(flag - 2) : nullptr; }
  // Says of numbers that they are no contact.
  static void strange(const double *numbers, carom_error *why);
  // Ends the contact of a slot.
  void drop(double *slot);
  // Packs the contact of a slot into numbers.
  carom_status pack(double *slot, carom_error *why);
  double bytes() const { return static_cast<double>(memory.capacity() * sizeof(uint64_t)); }

 private:
  // A contact belongs to one slot or to none, and has the law with which it was unpacked.
  struct Place {
    const double *owner;
    MadeLaw law;
  };
  std::vector<Place> places;
  std::vector<int> unused;
  std::size_t words = 0;    // of each touch
  std::vector<uint64_t> memory;

  carom_touch *touch(int place) { return reinterpret_cast<carom_touch *>(memory.data() + words * place); }
  // The index of the unpacked contact of a slot; -1 if it was not unpacked here.
  int index(const double *slot) const
  {
    const double place = -1.0 - slot[0];
    if (!(place >= 0.0 && place < static_cast<double>(places.size()))) return -1;
    const int known = static_cast<int>(place);
    return places[known].owner == slot ? known : -1;
  }
  carom_touch *unpack(double *slot, const MadeLaw &law, double radius_1, double radius_2, carom_error *why);
  void give_back(int place);
};

}    // namespace carom

#endif
