#include "wall_contact.h"

#include "touches.h"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace carom {

carom_touch *WallContact::touch(const MadeLaw &its, double radius, carom_error *why)
{
  const std::size_t size = carom_touch_size(its.get()) / sizeof(uint64_t);
  if (form == Form::IN_WORK && words.size() == size) {
    if (law != its) law = its;
    return place();
  }
  // The law was made anew, with or without torsion or rolling.
  if (pack(why) != CAROM_STATUS_OK) return nullptr;
  const std::size_t known = packed.size(), asked = carom_touch_pack_size(its.get());
  words.assign(size, 0);
  if (form == Form::PACKED) {
    if (packed[0] < 0.0) {
      Touches::strange(packed.data(), why);
      return nullptr;
    }
    if (known != asked) {
      memset(why, 0, sizeof *why);
      snprintf(why->text, sizeof why->text,
               "a contact has %zu numbers, and %zu in this run: law, torsion, rolling and slip_friction must be as in "
               "the run that wrote the restart file", known, asked);
      return nullptr;
    }
    if (carom_touch_unpack(its.get(), radius, INFINITY, packed.data(), place(), why) != CAROM_STATUS_OK) return nullptr;
  }
  form = Form::IN_WORK;
  law = its;
  return place();
}

carom_status WallContact::pack(carom_error *why)
{
  if (form != Form::IN_WORK) return CAROM_STATUS_OK;
  packed.resize(count());
  const carom_status status = carom_touch_pack(law.get(), place(), packed.data(), why);
  if (status != CAROM_STATUS_OK) return status;
  form = Form::PACKED;
  law.reset();
  return status;
}

int WallContact::count() const
{
  return static_cast<int>(form == Form::IN_WORK ? carom_touch_pack_size(law.get()) : packed.size());
}

void WallContact::take(const double *numbers, int count)
{
  packed.assign(numbers, numbers + count);
  form = Form::PACKED;
  law.reset();
}

void WallContact::drop()
{
  form = Form::NONE;
  law.reset();
  began = {};
}

// Whether so many numbers are contacts, their number first.
static bool are_contacts(const double *numbers, int count)
{
  if (count < 1 || !(numbers[0] >= 0.0 && numbers[0] <= wall_numbers::MOST_CONTACTS)) return false;
  const int contacts = static_cast<int>(numbers[0]);
  if (contacts != numbers[0]) return false;
  int at = 1;
  for (int k = 0; k < contacts; k++) {
    if (at >= count || !(numbers[at] >= 1.0 && numbers[at] <= wall_numbers::MOST)) return false;
    const int size = static_cast<int>(numbers[at]);
    if (size != numbers[at] || size > count - at - 1) return false;
    at += 1 + size;
  }
  return at == count;
}

int wall_numbers::part_of(const double *numbers, int count, int nth)
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
