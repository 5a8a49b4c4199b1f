#include "touches.h"

#include <cstring>

namespace carom {

carom_touch *Touches::unpack(double *slot, const carom_grains &grains, double radius_1,
                             double radius_2, carom_error *why)
{
  if (unused.empty()) {
    unused.push_back(static_cast<int>(pool.size()));
    pool.emplace_back();
  }
  const int place = unused.back();
  carom_touch &touch = pool[place];
  touch.mark = 0;
  if (carom_touch_unpack(&grains, radius_1, radius_2, slot, &touch, why) != CAROM_STATUS_OK)
    return nullptr;
  unused.pop_back();
  slot[0] = -1.0 - place;
  return &touch;
}

void Touches::drop(double *slot)
{
  if (is_unpacked(slot)) unused.push_back(index(slot));
  memset(slot, 0, NUMBERS * sizeof(double));
}

carom_status Touches::pack(double *slot, carom_error *why)
{
  if (!is_unpacked(slot)) return CAROM_STATUS_OK;
  const int place = index(slot);
  const carom_status status = carom_touch_pack(&pool[place], slot, why);
  if (status == CAROM_STATUS_OK) unused.push_back(place);
  return status;
}

}    // namespace carom
