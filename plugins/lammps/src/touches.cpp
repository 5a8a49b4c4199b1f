#include "touches.h"

#include <cstdio>
#include <cstring>

namespace carom {

carom_touch *Touches::unpack(double *slot, const carom_grains &grains, double radius_1,
                             double radius_2, carom_error *why)
{
  if (unused.empty()) {
    unused.push_back(static_cast<int>(pool.size()));
    pool.emplace_back();
    owners.push_back(nullptr);
  }
  const int place = unused.back();
  carom_touch &touch = pool[place];
  touch.mark = 0;
  if (carom_touch_unpack(&grains, radius_1, radius_2, slot, &touch, why) != CAROM_STATUS_OK)
    return nullptr;
  unused.pop_back();
  owners[place] = slot;
  slot[0] = -1.0 - place;
  return &touch;
}

void Touches::give_back(int place)
{
  owners[place] = nullptr;
  unused.push_back(place);
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
  memset(slot, 0, NUMBERS * sizeof(double));
}

carom_status Touches::pack(double *slot, carom_error *why)
{
  if (!is_unpacked(slot)) return CAROM_STATUS_OK;
  const int place = index(slot);
  if (place < 0) {
    strange(slot, why);
    return CAROM_STATUS_BAD_STATE;
  }
  const carom_status status = carom_touch_pack(&pool[place], slot, why);
  if (status == CAROM_STATUS_OK) give_back(place);
  return status;
}

int Touches::part_of(const double *numbers, int count, int nth)
{
  for (int at = 0;; nth--) {
    if (at >= count) return -1;
    const double size = numbers[at];
    // A part has its size at least.
    if (!(size >= 1.0 && size <= static_cast<double>(count - at))) return -1;
    if (nth > 0) {
      at += static_cast<int>(size);
      continue;
    }
    if (size < 2.0 || !is_count(numbers[at + 1]) || size != 2.0 + numbers[at + 1]) return -1;
    return at;
  }
}

}    // namespace carom
