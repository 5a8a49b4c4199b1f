// What a damaged restart file may hold in the slots of contacts, without a host: compiled with the sanitizers.
#include "../src/touches.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

using carom::Touches;

static void check(bool holds, const char *what)
{
  if (holds) return;
  printf("wrong: %s\n", what);
  exit(1);
}

static bool same(const carom::Touch &one, const carom::Touch &two)
{
  return one.plain == two.plain && one.rings == two.rings;
}

static carom::Constants constants(uint32_t law)
{
  const carom_material glass = {70e9, 0.22, 0};
  const carom_material rubber = {1e7, 0.5, 0};
  carom::Constants made;
  check(carom_grains_of(&glass, &rubber, 0.4, law, 0.0, 0.0, &made.grains, nullptr) == CAROM_STATUS_OK, "constants");
  if (law != CAROM_LAW_RINGS) return made;
  carom_rings *rings = nullptr;
  check(carom_rings_of(&made.grains.unit, &rings, nullptr) == CAROM_STATUS_OK, "rings");
  made.rings.reset(rings, carom_rings_free);
  return made;
}

// A slot that holds the numbers of two balls that were pressed and shifted.
static void fill(const carom::Constants &constants, double *slot)
{
  carom_touch plain;
  carom_ring_touch rings;
  memset(&plain, 0, sizeof plain);
  memset(&rings, 0, sizeof rings);
  carom::Touch touch;
  if (constants.rings) touch.rings = &rings;
  else touch.plain = &plain;
  carom_grain one = {{0.0, 0.0, 2e-3 - 1e-8}, {0.1, 0.0, -0.2}, {0.0, 0.0, 0.0}, 1e-3, 1e-5};
  const carom_grain two = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-3, 1e-5};
  carom_grain_load load;
  for (int step = 0; step < 20; step++) {
    one.place[0] += 1e-9;
    one.place[2] -= 2e-9;
    check(touch.step(constants, one, two, 1e-8, &load, nullptr, nullptr) == CAROM_STATUS_OK, "step");
  }
  memset(slot, 0, Touches::MOST * sizeof(double));
  const carom_status status =
      constants.rings ? carom_ring_touch_pack(&rings, slot, nullptr) : carom_touch_pack(&plain, slot, nullptr);
  check(status == CAROM_STATUS_OK && slot[0] > 0.0, "pack");
}

// Slots of a law, their contacts of so many numbers, so many of them changed at random.
static void go_through(uint32_t law, int numbers, int turns)
{
  const carom::Constants its = constants(law);
  static double slots[8][Touches::MOST];
  for (auto &slot : slots) fill(its, slot);
  Touches touches;
  carom_error why;
  const auto at = [&](double *slot) { return touches.at(slot, its, 1e-3, 1e-3, &why); };

  // What is unpacked here is found again, and packs to the same bits.
  static double before[8][Touches::MOST];
  memcpy(before, slots, sizeof slots);
  for (auto &slot : slots) {
    const carom::Touch touch = at(slot);
    check(touch && Touches::is_unpacked(slot) && same(at(slot), touch), "unpacked and found");
    check(same(touches.with_flag(touches.flag_of(slot)), touch), "found by its flag");
    check(touches.is_of_rings(slot) == (law == CAROM_LAW_RINGS), "of its law");
  }
  for (auto &slot : slots) check(touches.pack(slot, &why) == CAROM_STATUS_OK, "packed again");
  check(memcmp(before, slots, sizeof slots) == 0, "the same bits");

  // A first number that says of an unpacked contact where there is none of this slot.
  check(at(slots[0]) && at(slots[1]), "two in use");
  const double strange[] = {-1.0, -2.0, -3.0, -8.0, -9.0, -1e6, -1e18, -1e300, -0.5, -1.5,
                            -std::numeric_limits<double>::infinity()};
  for (const double number : strange) {
    double slot[Touches::MOST] = {number};
    check(!at(slot) && strstr(why.text, "damaged"), "refused");
    check(touches.pack(slot, &why) == CAROM_STATUS_BAD_STATE && slot[0] == number, "not packed");
    touches.flag_of(slot);
    touches.drop(slot);
    check(slot[0] == 0.0, "dropped");
  }
  check(!same(at(slots[0]), at(slots[1])), "two contacts, still each in its place");
  touches.drop(slots[0]);
  touches.drop(slots[1]);

  // Any number changed in any way: unpacked or refused, and packed or dropped.
  srand(1);
  int refused = 0;
  for (int turn = 0; turn < turns; turn++) {
    double slot[Touches::MOST];
    memcpy(slot, before[turn % 8], sizeof slot);
    const int place = rand() % (turn % 3 ? numbers : 8);
    unsigned long long bits;
    memcpy(&bits, slot + place, sizeof bits);
    bits ^= 1ULL << (rand() % 64);
    if (turn % 5 == 0) bits = ((unsigned long long) rand() << 33) ^ ((unsigned long long) rand() << 11) ^ rand();
    memcpy(slot + place, &bits, sizeof bits);
    if (!at(slot)) {
      refused++;
      continue;
    }
    if (turn % 2) touches.drop(slot);
    else check(touches.pack(slot, &why) == CAROM_STATUS_OK, "packed");
  }
  check(refused > turns / 200, "many are refused");
  fprintf(stderr, "law %u: %d of %d refused\n", law, refused, turns);
}

int main()
{
  go_through(CAROM_LAW_COULOMB, Touches::NUMBERS, 200000);
  go_through(CAROM_LAW_RINGS, Touches::OF_RINGS, 20000);

  // The numbers of a grain in a restart file, part by part.
  const double none = std::nan("");
  const double good[] = {3.0, 1.0, 2.0, 2.0, 0.0, 7.0};    // three numbers that are none of a wall, then no contact
  check(Touches::part_of(good, 6, 1) == 3, "the second part");
  check(Touches::part_of(good, 6, 0) == -1, "the first is not of a wall");
  check(Touches::part_of(good, 6, 2) == -1 && Touches::part_of(good, 6, 3) == -1, "beyond the last");
  check(Touches::part_of(good, 4, 1) == -1 && Touches::part_of(nullptr, 0, 0) == -1, "cut off");
  constexpr int ONE = 1 + Touches::NUMBERS, MORE = 1 + Touches::NUMBERS + Touches::AT_WALL;
  double whole[2 + ONE + MORE] = {2.0 + ONE + MORE, 2.0, ONE - 1.0};
  whole[2 + ONE] = MORE - 1.0;
  const auto part = [&whole](int count) { return Touches::part_of(whole, count, 0); };
  check(part(2 + ONE + MORE) == 0, "a whole one, of two contacts");
  check(part(1 + ONE + MORE) == -1, "one number short");
  for (const double count : {1.0, 3.0, 0.0, 1.5, -2.0, 1e300, none}) {
    whole[1] = count;
    check(part(2 + ONE + MORE) == -1, "another number of contacts");
  }
  whole[1] = 2.0;
  for (const int at : {2, 2 + ONE})
    for (const double count : {1e9, -5.0, 80.0, 0.0, 1e300, -1e300, none, 78.5, 1.0 * Touches::OF_RINGS}) {
      const double right = whole[at];
      whole[at] = count;
      check(part(2 + ONE + MORE) == -1, "a count that is none");
      whole[at] = right;
    }
  for (const double size : {0.0, -3.0, 1e9, 1e300, none, 0.5}) {
    const double wrong[] = {size, 1.0, 2.0, 2.0, 0.0};
    check(Touches::part_of(wrong, 5, 1) == -1 && Touches::part_of(wrong, 5, 0) == -1, "a size that is none");
  }
  printf("all is well\n");
}
