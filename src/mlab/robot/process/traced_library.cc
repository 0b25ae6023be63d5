#include "mlab/robot/process/traced_library.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <vector>

#include "mlab/base/hash.h"

namespace mlab::robot_process {
namespace {

struct Traced {
  std::uint64_t path_hash = 0;
  flow::FireFunction fire = nullptr;
  std::uint32_t node = 0;
};

// Sorted by hash. A fire function carries no data of its own, so what it finds stands here.
struct Trace {
  std::vector<Traced> nodes;
  robot_wire::Control* control = nullptr;  // never null
};
Trace& trace_of_process() {
  static robot_wire::Control unshared;
  static Trace trace{{}, &unshared};
  return trace;
}

void fire_traced(flow::Call& call) {
  const Trace& trace = trace_of_process();
  const auto found = std::ranges::lower_bound(trace.nodes, call.path_hash, {}, &Traced::path_hash);
  assert(found != trace.nodes.end() && "fires only once `trace` was called");
  trace.control->node.store(found->node, std::memory_order_relaxed);
  found->fire(call);
  trace.control->node.store(robot_wire::Control::kNobody, std::memory_order_relaxed);
}

// Told before the process ends, because what ends it is a signal like any other.
void tell_out_of_memory() {
  std::set_new_handler(nullptr);
  trace_of_process().control->out_of_memory.store(1);
  std::fputs("out of memory\n", stderr);
  std::abort();
}

}  // namespace

void TracedLibrary::add(std::span<const flow::Behavior* const> behaviors, flow::Library& library) {
  std::vector<const flow::Behavior*> added;
  for (const flow::Behavior* behavior : behaviors) {
    flow::Behavior& copy = behaviors_.emplace_back(*behavior);
    copy.fire = fire_traced;
    originals_.push_back(behavior);
    added.push_back(&copy);
  }
  library.add(added);
}

void TracedLibrary::trace(const flow::Network& network, const flow::Library& library,
                          robot_wire::Control& control) {
  Trace& trace = trace_of_process();
  trace = {{}, &control};
  std::set_new_handler(tell_out_of_memory);
  for (std::uint32_t i = 0; i < network.nodes.size(); ++i) {
    const flow::Node& node = network.nodes[i];
    if (node.kind != flow::Node::Kind::kBehavior) continue;
    const flow::Behavior* behavior = library.find(node.behavior).behavior;
    for (std::size_t k = 0; k < behaviors_.size(); ++k) {
      if (behavior == &behaviors_[k])
        trace.nodes.push_back({base::hash_text(node.name), originals_[k]->fire, i});
    }
  }
  std::ranges::sort(trace.nodes, {}, &Traced::path_hash);
}

}  // namespace mlab::robot_process
