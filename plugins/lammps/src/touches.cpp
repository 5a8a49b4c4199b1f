#include "touches.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace carom {

void Touches::fit(const MadeLaw &law)
{
  const std::size_t asked = carom_touch_size(law.get()) / sizeof(uint64_t);
  if (asked <= words) return;
  std::vector<uint64_t> wider(asked * places.size());
  for (std::size_t place = 0; place < places.size(); place++)
    std::copy_n(memory.data() + words * place, words, wider.data() + asked * place);
  memory.swap(wider);
  words = asked;
}

carom_touch *Touches::unpack(double *slot, const MadeLaw &law, double radius_1, double radius_2, carom_error *why)
{
  if (unused.empty()) {
    unused.push_back(static_cast<int>(places.size()));
    places.push_back({nullptr, nullptr});
    memory.resize(words * places.size());
  }
  const int place = unused.back();
  if (carom_touch_unpack(law.get(), radius_1, radius_2, slot, touch(place), why) != CAROM_STATUS_OK) return nullptr;
  unused.pop_back();
  places[place] = {slot, law};
  slot[0] = -1.0 - place;
  return touch(place);
}

void Touches::give_back(int place)
{
  places[place] = {nullptr, nullptr};
  unused.push_back(place);
}

void Touches::strange(const double *numbers, carom_error *why)
{
  memset(why, 0, sizeof *why);
  why->index = -1;
  why->value = numbers[0];
  strcpy(why->field, "mark");
  snprintf(why->text, sizeof why->text,
           "mark = %g is out of range: the numbers of a contact are damaged, in the restart file or since", numbers[0]);
}

void Touches::drop(double *slot)
{
  const int place = is_unpacked(slot) ? index(slot) : -1;
  if (place >= 0) give_back(place);
  slot[0] = 0.0;
}

carom_status Touches::pack(double *slot, carom_error *why)
{
  if (!is_unpacked(slot)) return CAROM_STATUS_OK;
  const int place = index(slot);
  if (place < 0) {
    strange(slot, why);
    return CAROM_STATUS_BAD_STATE;
  }
  const carom_status status = carom_touch_pack(places[place].law.get(), touch(place), slot, why);
  if (status == CAROM_STATUS_OK) give_back(place);
  return status;
}

}    // namespace carom
