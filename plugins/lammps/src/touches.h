// The contacts of one rank while it runs: kept as numbers in slots of the host's, which it moves from
// rank to rank and into restart files, and unpacked here between two such moves.
#ifndef CAROM_TOUCHES_H
#define CAROM_TOUCHES_H

#include "carom.h"
#include "touch.h"

#include <vector>

namespace carom {

// The first number of a slot is zero where nothing touches, positive where the slot holds a packed
// contact, and -1 - index where contact `index` is unpacked. A slot may come from a damaged restart file: only one
// that was unpacked here is believed.
class Touches {
 public:
  static constexpr int NUMBERS = CAROM_TOUCH_NUMBERS;
  // A slot with a twist: its numbers stand behind those of the contact and stay there.
  static constexpr int WITH_TWIST = NUMBERS + CAROM_TWIST_NUMBERS;
  static constexpr int OF_RINGS = CAROM_RING_TOUCH_NUMBERS;
  static constexpr int MOST = OF_RINGS > WITH_TWIST ? OF_RINGS : WITH_TWIST;
  static carom_twist *twist_of(double *slot) { return reinterpret_cast<carom_twist *>(slot + NUMBERS); }

  // The contact of a slot, unpacked; made if there is none. None if the numbers are no contact: `why` says so.
  Touch at(double *slot, const Constants &constants, double radius_1, double radius_2, carom_error *why)
  {
    if (!is_unpacked(slot)) return unpack(slot, constants, radius_1, radius_2, why);
    const int place = index(slot);
    if (place >= 0 && places[place].by_rings == (constants.rings != nullptr)) return touch(place);
    strange(slot, why);
    return {};
  }
  static bool is_unpacked(const double *slot) { return slot[0] < 0.0; }
  // Whether the contact of a slot is one of law rings.
  bool is_of_rings(const double *slot) const;

  // Whether a grain may have so many numbers of a contact in a restart file.
  static bool is_count(double count)
  {
    return count == 0.0 || count == NUMBERS || count == WITH_TWIST || count == OF_RINGS;
  }
  // Where the part of a fix begins among the numbers that a restart file has of a grain: each part says in its
  // first number how many it has, the next one in its second of how many a contact is made. -1 if they are not so.
  static int part_of(const double *numbers, int count, int nth);

  // The host's flag of a pair of grains: 0 apart, 1 in contact, above that it says where what is unpacked
  // is, without a look at the slot.
  int flag_of(const double *slot) const { return is_unpacked(slot) ? 2 + index(slot) : 1; }
  Touch with_flag(int flag) { return flag > 1 ? touch(flag - 2) : Touch(); }
  // Ends the contact of a slot; its twist is left to the caller.
  void drop(double *slot);
  // Makes a slot hold its contact as numbers.
  carom_status pack(double *slot, carom_error *why);
  double bytes() const
  {
    return static_cast<double>(plain.capacity() * sizeof(carom_touch) + rings.capacity() * sizeof(carom_ring_touch));
  }

 private:
  // A place stays in its pool; a slot owns it or none does.
  struct Place {
    const double *owner;
    bool by_rings;
    int at;
  };
  std::vector<Place> places;
  std::vector<int> unused[2];    // of law rings: the second
  std::vector<carom_touch> plain;
  std::vector<carom_ring_touch> rings;

  Touch touch(int place)
  {
    const Place &its = places[place];
    if (its.by_rings) return {nullptr, &rings[its.at]};
    return {&plain[its.at], nullptr};
  }
  // The place of the contact of a slot that is unpacked; -1 if it was not unpacked here.
  int index(const double *slot) const
  {
    const double place = -1.0 - slot[0];
    if (!(place >= 0.0 && place < static_cast<double>(places.size()))) return -1;
    const int known = static_cast<int>(place);
    return places[known].owner == slot ? known : -1;
  }
  Touch unpack(double *slot, const Constants &constants, double radius_1, double radius_2, carom_error *why);
  int free_place(bool by_rings);
  void give_back(int place);
  static void strange(const double *slot, carom_error *why);
};

}    // namespace carom

#endif
