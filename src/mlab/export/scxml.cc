#include "mlab/export/scxml.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "mlab/export/network_view.h"
#include "mlab/export/xml.h"

namespace mlab::exports {
namespace {

using flow::Node;
using Json = nlohmann::ordered_json;

/// A way out of a state: its condition in ECMAScript, and where to.
struct WayOut {
  std::string condition;
  std::string target;     ///< id
  bool is_taken = false;  ///< false: it leads to the state itself and changes nothing
};

class Chart {
 public:
  Chart(const Subject& subject, text::Diagnostics& sink)
      : view_(subject.network, subject.library), subject_(subject), sink_(sink) {}

  std::optional<std::string> run() {
    const std::size_t errors_before = sink_.error_count();
    std::vector<const Node*> regions;
    std::set<const Node*> seen;
    for (const Node* root : view_.roots()) collect(*root, regions, seen);
    if (regions.empty()) {
      sink_
          .error("no-sequence", subject_.robot.name.place,
                 fmt::format("robot `{}` has no sequence", subject_.robot.name.text))
          .hints = {"a state chart is made of `sequence { ... }`"};
      return std::nullopt;
    }
    out_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" "
        "version=\"1.0\" name=\"{}\" datamodel=\"ecmascript\">\n"
        "  <datamodel>\n    <data id=\"doing\" expr=\"{{}}\"/>\n  </datamodel>\n",
        escaped(subject_.robot.name.text));
    put_regions(regions, subject_.robot.name.text, "", "  ");
    out_ += "</scxml>\n";
    if (sink_.error_count() > errors_before) return std::nullopt;
    return std::move(out_);
  }

 private:
  // The sequences that run whenever `from` does. A select is one where sequences stand in it.
  void collect(const Node& from, std::vector<const Node*>& regions, std::set<const Node*>& seen) {
    if (active_.contains(&from) || !seen.insert(&from).second) return;
    if (from.kind == Node::Kind::kSelect) {
      collect_source(from.selector, regions, seen);
      if (has_sequence(from)) regions.push_back(&from);
      return;
    }
    if (from.kind == Node::Kind::kSequence) {
      regions.push_back(&from);
      return;
    }
    for (const Node* input : view_.inputs(from)) collect(*input, regions, seen);
  }
  void collect_source(const flow::Source& source, std::vector<const Node*>& regions,
                      std::set<const Node*>& seen) {
    const Node* node = source.kind == flow::Source::Kind::kName ? view_.node(source.text) : nullptr;
    if (node != nullptr) collect(*node, regions, seen);
  }

  bool has_sequence(const Node& select) {
    std::vector<const Node*> regions;
    std::set<const Node*> seen;
    for (const flow::Case& one : select.cases) collect_source(one.member, regions, seen);
    return !regions.empty();
  }

  // `busy`: a condition under which an outer state is left, so that nothing in it goes on.
  void put_regions(const std::vector<const Node*>& regions, const std::string& owner, const std::string& busy,
                   const std::string& indent) {
    for (const Node* region : regions) {
      if (!used_.insert(region).second) {
        sink_
            .error(
                "shared-sequence", region->place,
                fmt::format("sequence `{}` runs in several states or in several parts at once", region->name))
            .hints = {
            "a state chart has each sequence in one place: call the assemblage twice instead of sharing its "
            "value"};
        return;
      }
      active_.insert(region);
    }
    const bool is_parallel = regions.size() > 1;
    if (is_parallel) out_ += fmt::format("{}<parallel id=\"{}-parts\">\n", indent, escaped(owner));
    for (const Node* region : regions) {
      const std::string inner = is_parallel ? indent + "  " : indent;
      if (region->kind == Node::Kind::kSequence)
        put_sequence(*region, busy, inner);
      else
        put_select(*region, busy, inner);
    }
    if (is_parallel) out_ += indent + "</parallel>\n";
    for (const Node* region : regions) active_.erase(region);
  }

  static std::string value(const flow::Source& source) {
    if (source.kind == flow::Source::Kind::kConstant) return source.text == "true" ? "true" : "false";
    return fmt::format("_event.data['{}']", source.text);
  }

  std::vector<WayOut> ways_out(const Node& sequence, const flow::State& state) {
    std::vector<WayOut> out;
    for (const flow::Transition& one : state.transitions) {
      check_trigger(one);
      const bool stays = one.target == state.name && !one.restarts;
      out.push_back({fmt::format("{}{}", one.is_negated ? "!" : "", value(one.trigger)),
                     sequence.name + "." + one.target, !stays});
    }
    return out;
  }
  void check_trigger(const flow::Transition& transition) {
    std::vector<const Node*> regions;
    std::set<const Node*> seen;
    collect_source(transition.trigger, regions, seen);
    if (regions.empty() || !told_.insert(&transition).second) return;
    sink_
        .error("sequence-in-trigger", transition.trigger.place,
               fmt::format("a trigger that the sequence `{}` is part of", regions.front()->name))
        .hints = {"a state chart is given the values of triggers; it has no states to compute them"};
  }

  // Whether the first way out whose condition holds is one that is taken.
  static std::string leaves(const std::vector<WayOut>& ways) {
    std::string out = "false";
    for (auto way = ways.rbegin(); way != ways.rend(); ++way)
      out = fmt::format("({} ? {} : {})", way->condition, way->is_taken, out);
    return out;
  }
  static std::string either(const std::string& a, const std::string& b) {
    return a.empty() ? b : fmt::format("{} || {}", a, b);
  }

  // What is done there: the node, what it calls, and its inputs. It stands in the data model as long as the
  // state is active, by the name of its sequence or select.
  void put_doing(const std::string& owner, const std::string& state, const flow::Source& member,
                 const std::string& indent) {
    Json does = {{"state", state}};
    const Node* node = member.kind == flow::Source::Kind::kName ? view_.node(member.text) : nullptr;
    does[node == nullptr ? "value" : "node"] = member.text;
    if (node != nullptr && !node->behavior.empty()) does["component"] = node->behavior;
    for (std::size_t i = 0; node != nullptr && i < node->links.size(); ++i)
      does["inputs"][node->links[i].input].push_back(node->links[i].source.text);
    const std::string text = does.dump(-1, ' ', true, Json::error_handler_t::replace);
    const std::string place = escaped(fmt::format("doing['{}']", owner));
    out_ += fmt::format("{}<onentry>\n{}  <assign location=\"{}\" expr=\"{}\"/>\n{}</onentry>\n", indent,
                        indent, place, escaped(text), indent);
    out_ += fmt::format("{}<onexit>\n{}  <assign location=\"{}\" expr=\"null\"/>\n{}</onexit>\n", indent,
                        indent, place, indent);
  }

  void put_way(const WayOut& way, const std::string& busy, const std::string& event,
               const std::string& indent) {
    const std::string condition =
        busy.empty() ? way.condition : fmt::format("!({}) && {}", busy, way.condition);
    out_ += fmt::format("{}<transition{} cond=\"{}\"", indent, event, escaped(condition));
    if (way.is_taken) out_ += fmt::format(" target=\"{}\"", escaped(way.target));
    out_ += "/>\n";
  }

  // A sequence that starts looks at the triggers of its first state in the same cycle. Before the first cycle
  // there is none, and it waits in its start.
  void put_sequence(const Node& sequence, const std::string& busy, const std::string& indent) {
    const auto named = std::ranges::find_if(sequence.states, &flow::State::is_start);
    const flow::State& start = named != sequence.states.end() ? *named : sequence.states.front();
    const std::string id = escaped(sequence.name);
    const std::string inner = indent + "  ";
    out_ += fmt::format("{}<state id=\"{}-sequence\" initial=\"{}-starts\">\n{}<state id=\"{}-starts\">\n",
                        indent, id, id, inner, id);
    for (WayOut way : ways_out(sequence, start)) {
      way.is_taken = true;
      way.condition = fmt::format("_event && _event.data && {}", way.condition);
      put_way(way, "", "", inner + "  ");
    }
    out_ += fmt::format("{}  <transition target=\"{}\"/>\n{}</state>\n", inner,
                        escaped(sequence.name + "." + start.name), inner);
    for (const flow::State& state : sequence.states) {
      const std::vector<WayOut> ways = ways_out(sequence, state);
      out_ += fmt::format("{}<state id=\"{}\">\n", inner, escaped(sequence.name + "." + state.name));
      put_doing(sequence.name, sequence.name + "." + state.name, state.member, inner + "  ");
      for (const WayOut& way : ways) put_way(way, busy, " event=\"cycle\"", inner + "  ");
      std::vector<const Node*> regions;
      std::set<const Node*> seen;
      collect_source(state.member, regions, seen);
      if (!regions.empty())
        put_regions(regions, sequence.name + "." + state.name,
                    ways.empty() ? busy : either(busy, leaves(ways)), inner + "  ");
      out_ += inner + "</state>\n";
    }
    out_ += indent + "</state>\n";
  }

  // One state for each case, and one for no case at all.
  void put_select(const Node& select, const std::string& busy, const std::string& indent) {
    const std::string inner = indent + "  ";
    const std::string by = value(select.selector);
    std::vector<WayOut> ways;
    std::vector<std::int64_t> known;
    bool has_otherwise = false;
    for (const flow::Case& one : select.cases) {
      has_otherwise |= one.values.empty();
      known.insert(known.end(), one.values.begin(), one.values.end());
      if (!one.values.empty())
        ways.push_back({fmt::format("[{}].indexOf({}) >= 0", fmt::join(one.values, ", "), by),
                        select.name + "-" + case_name(one), true});
    }
    ways.push_back({fmt::format("[{}].indexOf({}) < 0", fmt::join(known, ", "), by),
                    select.name + (has_otherwise ? "-otherwise" : "-none"), true});
    out_ += fmt::format("{}<state id=\"{}-select\" initial=\"{}-starts\">\n{}<state id=\"{}-starts\">\n",
                        indent, escaped(select.name), escaped(select.name), inner, escaped(select.name));
    for (const WayOut& way : ways) {
      put_way({fmt::format("_event && _event.data && {}", way.condition), way.target, true}, "", "",
              inner + "  ");
      put_way(way, busy, " event=\"cycle\"", inner + "  ");
    }
    out_ += inner + "</state>\n";
    if (!has_otherwise) put_case(select.name, select.name + "-none", nullptr, ways, busy, inner);
    for (const flow::Case& one : select.cases)
      put_case(select.name, select.name + "-" + case_name(one), &one, ways, busy, inner);
    out_ += indent + "</state>\n";
  }
  void put_case(const std::string& name, const std::string& id, const flow::Case* one,
                const std::vector<WayOut>& ways, const std::string& busy, const std::string& indent) {
    out_ += fmt::format("{}<state id=\"{}\">\n", indent, escaped(id));
    if (one != nullptr) put_doing(name, id, one->member, indent + "  ");
    std::vector<WayOut> others = ways;
    for (WayOut& way : others) way.is_taken = way.target != id;
    for (const WayOut& way : others) {
      if (way.is_taken) put_way(way, busy, " event=\"cycle\"", indent + "  ");
    }
    if (one != nullptr) {
      std::vector<const Node*> regions;
      std::set<const Node*> seen;
      collect_source(one->member, regions, seen);
      if (!regions.empty()) put_regions(regions, id, either(busy, leaves(others)), indent + "  ");
    }
    out_ += indent + "</state>\n";
  }

  NetworkView view_;
  const Subject& subject_;
  text::Diagnostics& sink_;
  std::string out_;
  std::set<const Node*> used_;
  std::set<const flow::Transition*> told_;  // those that have an error already
  std::set<const Node*> active_;            // runs already where we are
};

}  // namespace

std::optional<std::string> write_scxml(const Subject& subject, text::Diagnostics& sink) {
  return Chart(subject, sink).run();
}

}  // namespace mlab::exports
