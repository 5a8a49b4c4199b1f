// What a damaged restart file may hold in the slots of contacts, without a host: compiled with the sanitizers.
#include "../src/touches.h"
#include "../src/wall_contact.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

using carom::Touches;

static void check(bool holds, const char *what)
{
  if (holds) return;
  printf("wrong: %s\n", what);
  exit(1);
}

static carom::MadeLaw law_of(uint32_t law, bool has_parts)
{
  const carom_material glass = {70e9, 0.22, 0};
  const carom_material rubber = {1e7, 0.5, 0};
  carom_law_options options = {};
  options.size = sizeof options;
  options.law = law;
  if (has_parts) {
    options.torsion = 1;
    options.rolling = {1e4, 1.0, 0.1};
  }
  carom_law *made = nullptr;
  check(carom_law_make(&glass, &rubber, 0.4, &options, &made, nullptr) == CAROM_STATUS_OK, "a law");
  return carom::MadeLaw(made, carom_law_free);
}

// A slot that holds the numbers of two balls that were pressed and shifted.
static void fill(const carom::MadeLaw &law, double *slot)
{
  std::vector<uint64_t> words(carom_touch_size(law.get()) / 8);
  carom_touch *touch = reinterpret_cast<carom_touch *>(words.data());
  carom_grain one = {{0.0, 0.0, 2e-3 - 1e-8}, {0.1, 0.0, -0.2}, {1.0, 0.0, 2.0}, 1e-3, 1e-5};
  const carom_grain two = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1e-3, 1e-5};
  carom_grain_load load;
  for (int step = 0; step < 20; step++) {
    one.place[0] += 1e-9;
    one.place[2] -= 2e-9;
    check(carom_touch_step(law.get(), touch, &one, &two, nullptr, 1e-8, &load, nullptr, nullptr) == CAROM_STATUS_OK,
          "step");
  }
  memset(slot, 0, Touches::MOST * sizeof(double));
  check(carom_touch_pack(law.get(), touch, slot, nullptr) == CAROM_STATUS_OK && slot[0] > 0.0, "pack");
}

// A contact with a wall that these numbers are, in work and back.
static bool goes_through(const carom::MadeLaw &law, const double *slot, int numbers)
{
  carom::WallContact contact;
  carom_error why;
  contact.take(slot, numbers);
  check(contact.is_in_use() && contact.count() == numbers, "taken");
  if (!contact.touch(law, 1e-3, &why)) return false;
  check(contact.count() == numbers, "as many numbers");
  check(contact.pack(&why) == CAROM_STATUS_OK, "packed at a wall");
  contact.drop();
  check(!contact.is_in_use(), "dropped");
  return true;
}

// Slots of a law, so many of them changed at random.
static void go_through(uint32_t kind, bool has_parts, int turns)
{
  const carom::MadeLaw its = law_of(kind, has_parts);
  const int numbers = static_cast<int>(carom_touch_pack_size(its.get()));
  static double slots[8][Touches::MOST];
  for (auto &slot : slots) fill(its, slot);
  Touches touches;
  touches.fit(its);
  carom_error why;
  const auto at = [&](double *slot) { return touches.at(slot, its, 1e-3, 1e-3, &why); };
  const auto unpacked = [&](double *slot) { return at(slot) != nullptr; };

  // What is unpacked here is found again, and packs to the same bits.
  static double before[8][Touches::MOST];
  memcpy(before, slots, sizeof slots);
  for (auto &slot : slots) {
    check(unpacked(slot) && Touches::is_unpacked(slot), "unpacked");
    const carom_touch *touch = at(slot);
    check(at(slot) == touch && touches.with_flag(touches.flag_of(slot)) == touch, "found, also by its flag");
  }
  // A law with more takes more place, and what is unpacked stays.
  const carom::MadeLaw larger = law_of(CAROM_LAW_RINGS, true);
  touches.fit(larger);
  for (auto &slot : slots) check(touches.pack(slot, &why) == CAROM_STATUS_OK, "packed again");
  check(memcmp(before, slots, sizeof slots) == 0, "the same bits");

  // A first number that says of an unpacked contact where there is none of this slot.
  check(unpacked(slots[0]) && unpacked(slots[1]), "two in use");
  const double strange[] = {-1.0, -2.0, -3.0, -8.0, -9.0, -1e6, -1e18, -1e300, -0.5, -1.5,
                            -std::numeric_limits<double>::infinity()};
  for (const double number : strange) {
    double slot[Touches::MOST] = {number};
    check(!unpacked(slot) && strstr(why.text, "damaged"), "refused");
    check(!goes_through(its, slot, numbers), "refused at a wall");
    check(touches.pack(slot, &why) == CAROM_STATUS_BAD_STATE && slot[0] == number, "not packed");
    touches.flag_of(slot);
    touches.drop(slot);
    check(slot[0] == 0.0, "dropped");
  }
  check(at(slots[0]) != at(slots[1]), "two contacts, still each in its place");
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
    const bool holds = goes_through(its, slot, numbers);
    const bool is_pair = unpacked(slot);
    check(is_pair == holds, "alike at a wall");
    if (!is_pair) {
      refused++;
      continue;
    }
    if (turn % 2) touches.drop(slot);
    else check(touches.pack(slot, &why) == CAROM_STATUS_OK, "packed");
  }
  check(refused > turns / 200, "many are refused");
  fprintf(stderr, "law %u: %d of %d refused\n", kind, refused, turns);
}

int main()
{
  go_through(CAROM_LAW_COULOMB, false, 100000);
  go_through(CAROM_LAW_COULOMB, true, 20000);
  go_through(CAROM_LAW_RINGS, false, 10000);

  // Numbers of another kind of contact.
  double slot[Touches::MOST];
  fill(law_of(CAROM_LAW_COULOMB, false), slot);
  carom::WallContact contact;
  carom_error why;
  contact.take(slot, 82);
  check(!contact.touch(law_of(CAROM_LAW_COULOMB, true), 1e-3, &why) && strstr(why.text, "82 numbers"), "other numbers");

  // The numbers of a grain in a restart file, part by part.
  const double none = std::nan("");
  const double good[] = {3.0, 1.0, 2.0, 2.0, 0.0, 7.0};    // three numbers that are none of a wall, then no contact
  check(carom::wall_numbers::part_of(good, 6, 1) == 3, "the second part");
  check(carom::wall_numbers::part_of(good, 6, 0) == -1, "the first is not of a wall");
  check(carom::wall_numbers::part_of(good, 6, 2) == -1 && carom::wall_numbers::part_of(good, 6, 3) == -1, "beyond the last");
  check(carom::wall_numbers::part_of(good, 4, 1) == -1 && carom::wall_numbers::part_of(nullptr, 0, 0) == -1, "cut off");
  constexpr int ONE = 1 + 82, MORE = 1 + 82 + 17;
  double whole[2 + ONE + MORE] = {2.0 + ONE + MORE, 2.0, ONE - 1.0};
  whole[2 + ONE] = MORE - 1.0;
  const auto part = [&whole](int count) { return carom::wall_numbers::part_of(whole, count, 0); };
  check(part(2 + ONE + MORE) == 0, "a whole one, of two contacts");
  check(part(1 + ONE + MORE) == -1, "one number short");
  for (const double count : {1.0, 3.0, 0.0, 1.5, -2.0, 1e300, none}) {
    whole[1] = count;
    check(part(2 + ONE + MORE) == -1, "another number of contacts");
  }
  whole[1] = 2.0;
  for (const int at : {2, 2 + ONE})
    for (const double count : {1e9, -5.0, 80.0, 0.0, 1e300, -1e300, none, 78.5, 314.0}) {
      const double right = whole[at];
      whole[at] = count;
      check(part(2 + ONE + MORE) == -1, "a count that is none");
      whole[at] = right;
    }
  for (const double size : {0.0, -3.0, 1e9, 1e300, none, 0.5}) {
    const double wrong[] = {size, 1.0, 2.0, 2.0, 0.0};
    check(carom::wall_numbers::part_of(wrong, 5, 1) == -1 && carom::wall_numbers::part_of(wrong, 5, 0) == -1, "a size that is none");
  }
  printf("all is well\n");
}
