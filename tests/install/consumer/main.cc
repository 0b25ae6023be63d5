// Steps the procedure of keep_left.cnl once, with what an installed mlab offers.

#include <cstdio>
#include <span>

#include "mlab/flow/probe.h"
#include "mlab/schema/procedure.h"

std::span<const mlab::flow::Behavior* const> mlab_consumer_behaviors();

int main() {
  const auto behaviors = mlab_consumer_behaviors();
  if (behaviors.size() != 1 || behaviors[0]->name != "KeepLeft") return 1;
  mlab::flow::BehaviorProbe probe(*behaviors[0]);
  probe.set("strength", 2.5);
  probe.step();
  const auto& push = probe.output<mlab::geom::Vector>();
  std::printf("KeepLeft pushes by %g to the left\n", push.y);
  return push.y == 2.5 ? 0 : 1;
}
