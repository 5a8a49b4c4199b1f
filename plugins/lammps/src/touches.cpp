#include "touches.h"

#include <cstdio>
#include <cstring>

namespace carom {

// A free index in the pool of a type.
int Touches::free_place(bool by_rings)
{
  std::vector<int> &of_form = unused[by_rings];
  if (of_form.empty()) {
    of_form.push_back(static_cast<int>(places.size()));
    places.push_back({nullptr, by_rings, static_cast<int>(by_rings ? rings.size() : plain.size())});
    if (by_rings) rings.emplace_back();
    else plain.emplace_back();
  }
  return of_form.back();
}

Touch Touches::unpack(double *slot, const Constants &constants, double radius_1, double radius_2, carom_error *why,
                      const double *friction)
{
  const bool by_rings = constants.rings != nullptr;
  const int place = free_place(by_rings);
  const Touch made = touch(place);
  carom_status status;
  if (by_rings) {
    made.rings->mark = 0;
    status = carom_ring_touch_unpack(&constants.grains, constants.rings.get(), radius_1, radius_2, slot, made.rings, why);
  } else {
    made.plain->mark = 0;
    const carom_grains *grains = &constants.grains;
    if (friction && grains->slip_friction_b != 0.0)
      status = carom_touch_unpack_with_friction(grains, radius_1, radius_2, *friction, slot, made.plain, why);
    else
      status = carom_touch_unpack(grains, radius_1, radius_2, slot, made.plain, why);
  }
  if (status != CAROM_STATUS_OK) return {};
  unused[by_rings].pop_back();
  places[place].owner = slot;
  slot[0] = -1.0 - place;
  return made;
}

bool Touches::is_of_rings(const double *slot) const
{
  if (!is_unpacked(slot)) return slot[0] == CAROM_RING_TOUCH_MARK;
  const int place = index(slot);
  return place >= 0 && places[place].by_rings;
}

void Touches::give_back(int place)
{
  places[place].owner = nullptr;
  unused[places[place].by_rings].push_back(place);
}

void Touches::strange(const double *slot, carom_error *why)
{
  memset(why, 0, sizeof *why);
  why->index = -1;
  why->value = slot[0];
  strcpy(why->field, "mark");
  snprintf(why->text, sizeof why->text,
           "mark = %g is out of range: the numbers of a contact are damaged, in the restart file or since", slot[0]);
}

void Touches::drop(double *slot)
{
  const int place = is_unpacked(slot) ? index(slot) : -1;
  if (place >= 0) give_back(place);
  memset(slot, 0, (place >= 0 && places[place].by_rings ? OF_RINGS : NUMBERS) * sizeof(double));
}

carom_status Touches::pack(double *slot, carom_error *why, double *friction)
{
  if (!is_unpacked(slot)) return CAROM_STATUS_OK;
  const int place = index(slot);
  if (place < 0) {
    strange(slot, why);
    return CAROM_STATUS_BAD_STATE;
  }
  const Touch its = touch(place);
  carom_status status = CAROM_STATUS_OK;
  if (friction && its.plain) status = carom_touch_friction(its.plain, friction, why);
  if (status == CAROM_STATUS_OK)
    status = its.rings ? carom_ring_touch_pack(its.rings, slot, why) : carom_touch_pack(its.plain, slot, why);
  if (status == CAROM_STATUS_OK) give_back(place);
  return status;
}

// Whether so many numbers are contacts, their number first.
static bool are_contacts(const double *numbers, int count)
{
  if (count < 1 || !(numbers[0] >= 0.0 && numbers[0] <= Touches::MOST_AT_WALL)) return false;
  const int contacts = static_cast<int>(numbers[0]);
  if (contacts != numbers[0]) return false;
  int at = 1;
  for (int k = 0; k < contacts; k++) {
    if (at >= count || !Touches::is_count(numbers[at]) || numbers[at] > count - at - 1.0) return false;
    at += 1 + static_cast<int>(numbers[at]);
  }
  return at == count;
}

int Touches::part_of(const double *numbers, int count, int nth)
{
  for (int at = 0;; nth--) {
    if (at >= count) return -1;
    const double size = numbers[at];
    // A part has at least its minimum size.
    if (!(size >= 1.0 && size <= static_cast<double>(count - at))) return -1;
    if (nth > 0) {
      at += static_cast<int>(size);
      continue;
    }
    if (static_cast<int>(size) != size) return -1;
    return are_contacts(numbers + at + 1, static_cast<int>(size) - 1) ? at : -1;
  }
}

}    // namespace carom
