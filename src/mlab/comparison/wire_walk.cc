#include "mlab/comparison/wire_walk.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/core.h>

#include "mlab/percept/sensors.h"
#include "mlab/text/shown.h"

namespace mlab::comparison {
namespace {

constexpr std::size_t kMostConsequences = 12;

using flow::NodeWires;
using flow::Port;
using flow::Program;

// What is known of a program's values by where they stand in its frame.
class Values {
 public:
  explicit Values(const Program& program) {
    for (const Port& port : program.ports()) ports_.emplace(port.offset, &port);
    for (const NodeWires& node : program.wires()) nodes_.emplace(node.output, &node);
  }
  // Null: it is a conversion between two, and has no name.
  const Port* port(std::uint32_t offset) const {
    const auto found = ports_.find(offset);
    return found == ports_.end() ? nullptr : found->second;
  }
  // Null: a parameter or constant.
  const NodeWires* node(std::uint32_t offset) const {
    const auto found = nodes_.find(offset);
    return found == nodes_.end() ? nullptr : found->second;
  }
  // The ports that come into a node, through conversions.
  std::vector<const Port*> sources(const NodeWires& node) const {
    std::vector<const Port*> out;
    std::set<std::uint32_t> seen;
    std::vector<std::uint32_t> open(node.sources.rbegin(), node.sources.rend());
    while (!open.empty()) {
      const std::uint32_t offset = open.back();
      open.pop_back();
      if (!seen.insert(offset).second) continue;
      if (const Port* const found = port(offset)) {
        out.push_back(found);
      } else if (const NodeWires* const conversion = this->node(offset)) {
        open.insert(open.end(), conversion->sources.rbegin(), conversion->sources.rend());
      }
    }
    return out;
  }

 private:
  std::map<std::uint32_t, const Port*> ports_;
  std::map<std::uint32_t, const NodeWires*> nodes_;
};

std::string behavior_name(const NodeWires& node) {
  return node.behavior == nullptr ? "" : std::string(node.behavior->name);
}

// Constants have the node's own name in front; so a node that was wired otherwise reads other paths.
std::string paths_of(const std::vector<const Port*>& ports) {
  std::string out;
  for (const Port* const port : ports) out += fmt::format("{}`{}`", out.empty() ? "" : ", ", port->path);
  return out.empty() ? "nothing" : out;
}

class Walk {
 public:
  Walk(const ProgramPair& programs, const ProgramPair::Frames& frames, const ProgramPair::PortPair& first)
      : programs_(programs),
        frames_(frames),
        first_(first),
        values_{Values(*programs.programs()[0]), Values(*programs.programs()[1])} {}

  WireWalk make() {
    const NodeWires* const a = values_[0].node(first_.ports[0]->offset);
    const NodeWires* const b = values_[1].node(first_.ports[1]->offset);
    if (a != nullptr && b != nullptr) look_at(*a, *b);
    follow();
    return std::move(out_);
  }

 private:
  void look_at(const NodeWires& a, const NodeWires& b) {
    if (behavior_name(a) != behavior_name(b))
      out_.causes.push_back(fmt::format("`{}` is another component: {} and {}", first_.ports[0]->path,
                                        text::shown(behavior_name(a)), text::shown(behavior_name(b))));
    const std::vector<const Port*> sources = values_[0].sources(a);
    const std::vector<const Port*> theirs = values_[1].sources(b);
    if (!std::ranges::equal(sources, theirs, {}, &Port::path, &Port::path))
      out_.causes.push_back(fmt::format("`{}` is wired otherwise: it reads {} in A and {} in B",
                                        first_.ports[0]->path, paths_of(sources), paths_of(theirs)));
    for (const ProgramPair::PortPair& setting : programs_.settings()) {
      if (std::ranges::find(sources, setting.ports[0]) == sources.end()) continue;
      if (!programs_.differs(setting, frames_)) continue;
      const Value value = value_of(setting, frames_);
      const bool is_parameter = setting.ports[0]->role == Port::Role::kParameter;
      out_.causes.push_back(fmt::format("it reads the {} `{}`, which is {} in A and {} in B",
                                        is_parameter ? "parameter" : "constant", value.path, value.values[0],
                                        value.values[1]));
    }
    for (const Port* const source : sources) {
      if (source->type->kind == flow::TypeKind::kList) out_.lists.push_back(source->path);
    }
    if (a.is_delay) out_.causes.emplace_back("it gives what its source was in the cycle before");
    if (a.behavior == nullptr) return;
    for (const flow::Need& need : a.behavior->needs)
      out_.senses += fmt::format("{}{}", out_.senses.empty() ? "" : ", ", percept::info(need.sensor).name);
  }

  // All that differs and is reached from the first difference.
  void follow() {
    std::map<std::uint32_t, const ProgramPair::PortPair*> differing;
    for (const ProgramPair::PortPair& pair : programs_.outputs()) {
      if (programs_.differs(pair, frames_)) differing.emplace(pair.ports[0]->offset, &pair);
    }
    out_.values = differing.size();
    std::set<std::uint32_t> reached = {first_.ports[0]->offset};
    // Nodes stand behind their sources; only what a delay closes to a loop comes in another cycle.
    for (const auto& [offset, pair] : differing) {
      const NodeWires* const node = values_[0].node(offset);
      if (node == nullptr || reached.contains(offset)) continue;
      const bool is_reached = std::ranges::any_of(
          values_[0].sources(*node), [&](const Port* source) { return reached.contains(source->offset); });
      if (!is_reached) continue;
      reached.insert(offset);
      if (out_.consequences.size() < kMostConsequences) out_.consequences.push_back(value_of(*pair, frames_));
    }
  }

  const ProgramPair& programs_;
  const ProgramPair::Frames& frames_;
  const ProgramPair::PortPair& first_;
  Both<Values> values_;
  WireWalk out_;
};

}  // namespace

WireWalk walk_wires(const ProgramPair& programs, const ProgramPair::Frames& frames,
                    const ProgramPair::PortPair& first) {
  return Walk(programs, frames, first).make();
}

}  // namespace mlab::comparison
