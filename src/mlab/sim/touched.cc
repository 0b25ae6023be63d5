#include "mlab/sim/touched.h"

#include <algorithm>
#include <ranges>

namespace mlab::sim {
namespace {

bool is_same(const Statics& before, const Statics& now, std::uint32_t disc) {
  return disc < before.discs().size() && disc < now.discs().size() &&
         before.discs()[disc].center == now.discs()[disc].center &&
         before.discs()[disc].radius == now.discs()[disc].radius;
}

bool is_same_group(const Statics& before, const Statics& now, Thing group) {
  const auto of_group = [group](const Wall& wall) { return thing_of_wall(wall.group) == group; };
  const auto is_same_wall = [](const Wall& a, const Wall& b) {
    return a.segment.a == b.segment.a && a.segment.b == b.segment.b;
  };
  return std::ranges::equal(before.walls() | std::views::filter(of_group),
                            now.walls() | std::views::filter(of_group), is_same_wall);
}

}  // namespace

void forget_changed(Bodies& bodies, const Statics& before, const Statics& now, double time) {
  for (Touched& touched : bodies.touched) {
    for (std::size_t k = 0; k < touched.thing.size(); ++k) {
      const Thing thing = touched.thing[k];
      if (touched.until[k] <= time || is_body(thing) || is_roamer(thing) || thing == kNoThing) continue;
      const bool stays =
          is_disc(thing) ? is_same(before, now, thing - thing_of_disc(0)) : is_same_group(before, now, thing);
      if (!stays) touched.until[k] = -1;
    }
  }
}

void forget_roamers(Bodies& bodies) {
  for (Touched& touched : bodies.touched) {
    for (std::size_t k = 0; k < touched.thing.size(); ++k) {
      if (is_roamer(touched.thing[k])) touched.until[k] = -1;
    }
  }
}

bool Touched::meet(Thing met, double time) {
  std::size_t oldest = 0;
  for (std::size_t k = 0; k < thing.size(); ++k) {
    if (thing[k] == met && until[k] >= time) {
      until[k] = time + kSameContact;
      return false;
    }
    if (until[k] < until[oldest]) oldest = k;
  }
  thing[oldest] = met;
  until[oldest] = time + kSameContact;
  return true;
}

}  // namespace mlab::sim
