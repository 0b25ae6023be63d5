#include "mlab/sim/radio.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mlab/base/hash.h"
#include "mlab/base/random.h"
#include "mlab/geom/outline.h"

namespace mlab::sim {
namespace {

const RadioSpec& radio_of(const Sensors::Scene& scene, std::uint32_t body) {
  return scene.kinds[scene.bodies.kind[body]].spec.radio;
}

bool is_silent(const Sensors::Scene& scene, std::uint32_t body) {
  return std::ranges::any_of(scene.silences, [&](const Outline& outline) {
    return geom::is_within(outline, scene.bodies.position(body));
  });
}

}  // namespace

double signal_between(const Sensors::Scene& scene, std::uint32_t a, std::uint32_t b,
                      std::vector<std::uint32_t>& walls) {
  const double range = binding::common_range(radio_of(scene, a), radio_of(scene, b));
  const geom::Point here = scene.bodies.position(a);
  const geom::Point there = scene.bodies.position(b);
  const double distance = geom::distance(here, there);
  if (range != 0.0 && distance >= range) return 0.0;
  if (is_silent(scene, a) || is_silent(scene, b)) return 0.0;
  return binding::signal_strength(distance, range,
                                  range == 0.0 ? 0 : scene.statics.walls_between(here, there, walls));
}

void Radio::link(const Sensors::Scene& scene) {
  const Bodies& bodies = scene.bodies;
  const auto count = static_cast<std::uint32_t>(bodies.count());
  seed_ = scene.seed;
  cycle_ = scene.cycle;
  parents_.resize(count);
  std::iota(parents_.begin(), parents_.end(), 0U);
  losses_.resize(count);
  robots_.resize(count);
  silent_.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    losses_[i] = radio_of(scene, i).loss;
    robots_[i] = bodies.robot[i].value;
    silent_[i] = static_cast<std::uint8_t>(bodies.present[i] == 0 || is_silent(scene, i));
  }
  std::uint32_t everywhere = count;  // the first of those that are heard everywhere
  for (std::uint32_t i = 0; i < count; ++i) {
    if (silent_[i] != 0) continue;
    const double range = radio_of(scene, i).range;
    if (range == 0.0) {
      if (everywhere == count) everywhere = i;
      join(everywhere, i);
    } else {
      link_near(scene, i, range);
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) parents_[i] = root_of(i);
}

void Radio::link_near(const Sensors::Scene& scene, std::uint32_t body, double range) {
  std::uint32_t root = root_of(body);
  scene.grid.visit(Box::around(scene.bodies.x[body], scene.bodies.y[body], range),
                   [&](const PointGrid::Item& item) {
                     if (item.id == body || silent_[item.id] != 0 || root_of(item.id) == root) return;
                     if (signal_between(scene, body, item.id, walls_) <= 0.0) return;
                     join(body, item.id);
                     root = root_of(body);
                   });
}

// The way to it is shortened as it is gone.
std::uint32_t Radio::root_of(std::uint32_t body) {
  while (parents_[body] != body) {
    parents_[body] = parents_[parents_[body]];
    body = parents_[body];
  }
  return body;
}

void Radio::join(std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax({root_of(a), root_of(b)});
  parents_[high] = low;
}

std::uint32_t Radio::net_of(BodyIndex body) const {
  return parents_[body.value];
}

bool Radio::arrives(BodyIndex from, BodyIndex to) const {
  if (net_of(from) != net_of(to)) return false;
  const double loss = losses_[from.value];
  constexpr std::uint64_t kRadio = base::hash_text("radio");
  return loss == 0.0 ||
         base::Random::of(seed_, robots_[from.value], base::combine_bits(kRadio, robots_[to.value]), cycle_)
                 .uniform() >= loss;
}

}  // namespace mlab::sim
