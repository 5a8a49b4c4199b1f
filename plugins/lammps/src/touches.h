// The contacts of one rank during a run: stored as numbers in slots of the host, which moves them between
// ranks and into restart files, and unpacked here between two such moves.
#ifndef CAROM_TOUCHES_H
#define CAROM_TOUCHES_H

#include "carom.h"
#include "touch.h"

#include <vector>

namespace carom {

// The first number of a slot is zero without contact, positive if the slot holds a packed contact, and -1 -
// index if contact `index` is unpacked. Since a slot may come from a damaged restart file, an index is
// accepted only if the contact was unpacked here.
class Touches {
 public:
  static constexpr int NUMBERS = CAROM_TOUCH_NUMBERS;
  // A slot with a twist: its numbers follow those of the contact and stay in the slot.
  static constexpr int WITH_TWIST = NUMBERS + CAROM_TWIST_NUMBERS;
  static constexpr int OF_RINGS = CAROM_RING_TOUCH_NUMBERS;
  static constexpr int MOST = OF_RINGS > WITH_TWIST ? OF_RINGS : WITH_TWIST;
  // Behind the numbers of a contact: its rolling resistance, if there is one.
  static constexpr int ROLL = CAROM_ROLL_NUMBERS;
  static carom_roll *roll_at(double *place) { return reinterpret_cast<carom_roll *>(place); }
  // The coefficient of a contact whose friction depends on the slip speed of its first touch.
  static constexpr int FRICTION = 1;
  // The heat that a contact of grains made in the last step, and since it began: at the end of its slot.
  static constexpr int HEATS = 2;
  // What a wall may keep of a contact behind its numbers: rolling resistance, and how the wall was where it began.
  struct Began {
    double curvature[2];    // along the axis x of the contact and across it
    // Of a mesh, in the axes of its file, as they are now: by its normal a contact is known.
    double normal[3], axis[3];
  };
  static constexpr int AT_WALL = ROLL + static_cast<int>(sizeof(Began) / sizeof(double));
  static Began *began_at(double *place) { return reinterpret_cast<Began *>(place + ROLL); }
  // A grain has at most so many contacts with one wall.
  static constexpr int MOST_AT_WALL = 16;
  static carom_twist *twist_of(double *slot) { return reinterpret_cast<carom_twist *>(slot + NUMBERS); }

  // The unpacked contact of a slot; new if there is none. Null if the numbers are not a contact: `why` says
  // so. `friction` is the place of its coefficient, if it has one.
  Touch at(double *slot, const Constants &constants, double radius_1, double radius_2, carom_error *why,
           const double *friction = nullptr)
  {
    if (!is_unpacked(slot)) return unpack(slot, constants, radius_1, radius_2, why, friction);
    const int place = index(slot);
    if (place >= 0 && places[place].by_rings == (constants.rings != nullptr)) return touch(place);
    strange(slot, why);
    return {};
  }
  static bool is_unpacked(const double *slot) { return slot[0] < 0.0; }
  // Whether the contact of a slot uses the law of rings.
  bool is_of_rings(const double *slot) const;

  // Whether a restart file may contain this number of values for a contact with a wall.
  static bool is_count(double count) { return is_count_of_touch(count) || count_at_wall(count) > 0; }
  // How many of these values a wall keeps of a contact behind its numbers.
  static int count_at_wall(double count)
  {
    for (const int more : {AT_WALL, AT_WALL + FRICTION})
      if (is_count_of_touch(count - more)) return more;
    return 0;
  }
  static bool is_count_of_touch(double count)
  {
    return count == NUMBERS || count == WITH_TWIST || count == OF_RINGS;
  }
  // Index of the values of one fix among those that a restart file has for a grain. The first value of each part is
  // its length, the second the number of contacts; each of these begins with its size. -1 if the values are not valid.
  static int part_of(const double *numbers, int count, int nth);

  // The host's flag of a pair of grains: 0 separated, 1 in contact; larger values give the index of the
  // unpacked contact without reading the slot.
  int flag_of(const double *slot) const { return is_unpacked(slot) ? 2 + index(slot) : 1; }
  Touch with_flag(int flag) { return flag > 1 ? touch(flag - 2) : Touch(); }
  // Ends the contact of a slot; the caller ends its twist.
  void drop(double *slot);
  // Packs the contact of a slot into numbers, and its coefficient of friction if it has a place.
  carom_status pack(double *slot, carom_error *why, double *friction = nullptr);
  double bytes() const
  {
    return static_cast<double>(plain.capacity() * sizeof(carom_touch) + rings.capacity() * sizeof(carom_ring_touch));
  }

 private:
  // A contact keeps its index in its pool; it belongs to one slot or to none.
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
    // Without rings a contact's index in its pool is that of its place, which need not be read.
    if (rings.empty()) return {&plain[place], nullptr};
    const Place &its = places[place];
    if (its.by_rings) return {nullptr, &rings[its.at]};
    return {&plain[its.at], nullptr};
  }
  // The index of the unpacked contact of a slot; -1 if it was not unpacked here.
  int index(const double *slot) const
  {
    const double place = -1.0 - slot[0];
    if (!(place >= 0.0 && place < static_cast<double>(places.size()))) return -1;
    const int known = static_cast<int>(place);
    return places[known].owner == slot ? known : -1;
  }
  Touch unpack(double *slot, const Constants &constants, double radius_1, double radius_2, carom_error *why,
               const double *friction);
  int free_place(bool by_rings);
  void give_back(int place);
  static void strange(const double *slot, carom_error *why);
};

}    // namespace carom

#endif
