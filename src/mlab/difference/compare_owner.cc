#include "mlab/difference/compare_owner.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/print/print.h"

namespace mlab::difference {
namespace {

using cdl::ModelInput;
using cdl::ModelNode;
using cdl::ModelPage;
using cdl::OwnerModel;
using Kind = ModelNode::Kind;
using Role = cdl::InputRole;

constexpr std::size_t kMostNamed = 8;  // of an order, before it is cut short

text::Place place_of(const ModelNode& node) {
  if (node.drive != nullptr) return node.drive->binding.place;
  if (node.let != nullptr) return node.let->name.place;
  return node.expression == nullptr ? text::Place{} : node.expression->place;
}

/// Two pages of which the nodes have their partners.
class PageComparison {
 public:
  PageComparison(const ModelPage& before, const ModelPage& after, Prints& prints, Comparison& out)
      : before_(before),
        after_(after),
        prints_(prints),
        nodes_(match_nodes(before, after, prints)),
        out_(out) {}

  const Pairs& nodes() const { return nodes_; }

  void run() {
    for (std::size_t i = 0; i < before_.nodes.size(); ++i) {
      if (nodes_.to_after[i] < 0) tell_alone(before_.nodes[i], What::kRemoved);
    }
    for (std::size_t i = 0; i < after_.nodes.size(); ++i) {
      if (nodes_.to_before[i] >= 0)
        compare(before_.nodes[static_cast<std::size_t>(nodes_.to_before[i])], after_.nodes[i]);
      else
        tell_alone(after_.nodes[i], What::kAdded);
    }
    compare_results();
  }

 private:
  Difference on_page(Thing thing) const {
    Difference out;
    out.thing = thing;
    out.page_before = before_.path;
    out.page_after = after_.path;
    return out;
  }

  void tell_alone(const ModelNode& node, What what) {
    if (node.kind == Kind::kParameter || node.kind == Kind::kOuter) return;
    Difference one = on_page(Thing::kNode);
    one.what = what;
    one.kind = component_of(node);
    (what == What::kAdded ? one.name_after : one.name_before) = node.name;
    (what == What::kAdded ? one.place_after : one.place_before) = place_of(node);
    out_.meaning.push_back(std::move(one));
  }

  void compare(const ModelNode& before, const ModelNode& after) {
    if (before.kind == Kind::kParameter || before.kind == Kind::kOuter) return;
    Difference one = on_page(Thing::kNode);
    one.kind = component_of(after);
    one.name_before = before.name;
    one.name_after = after.name;
    one.place_before = place_of(before);
    one.place_after = place_of(after);
    const std::string& was = given_name(before);
    const std::string& is = given_name(after);
    // Names that follow from where a node stands are nobody's; nor is one given that it had by itself.
    if (was != is && before.name != after.name) note(one, "name", before.name, after.name);
    if (is_component(before)) {
      const std::string component = component_of(before);
      if (prints_.renames.declaration(component) != one.kind) note(one, "component", component, one.kind);
    }
    if (before.let != nullptr && after.let != nullptr) note(one, "help", before.let->help, after.let->help);
    compare_inputs(before, after, one);
    if (settle(one)) out_.meaning.push_back(std::move(one));
  }

  // ---- inputs

  void compare_inputs(const ModelNode& before, const ModelNode& after, Difference& out) {
    const InputGroups olds = inputs_of(before, &prints_.renames);
    const InputGroups news = inputs_of(after, nullptr);
    static const std::vector<const ModelInput*> kNone;
    for (const auto& [port, inputs] : olds) {
      const auto found = news.find(port);
      compare_port(before, after, port, inputs, found == news.end() ? kNone : found->second, out);
    }
    for (const auto& [port, inputs] : news) {
      if (!olds.contains(port)) compare_port(before, after, port, kNone, inputs, out);
    }
  }

  // The active part beside a name, which no node stands for.
  static const cdl::Expression* active_beside(const ModelInput& input) {
    const bool is_name = input.written && std::holds_alternative<cdl::Name>(input.written->what);
    return is_name ? input.written->active.get() : nullptr;
  }

  bool is_same_active(const ModelInput& before, const ModelInput& after) {
    const cdl::Expression* was = active_beside(before);
    const cdl::Expression* is = active_beside(after);
    if (was == nullptr || is == nullptr) return was == is;
    return prints_.before.content(*was) == prints_.after.content(*is);
  }

  bool is_same(const ModelInput& before, const ModelInput& after) {
    if (before.from >= 0 || after.from >= 0)
      return before.from >= 0 && after.from >= 0 &&
             nodes_.to_after[static_cast<std::size_t>(before.from)] == after.from &&
             is_same_active(before, after);
    // What a formula is called is its node's name.
    if (before.role == Role::kFormula && after.role == Role::kFormula)
      return prints_.before.content(*before.written) == prints_.after.content(*after.written);
    return prints_.before.of(before.written) == prints_.after.of(after.written);
  }

  // A wire that comes and goes with the node that it leads from is nothing of its own.
  bool is_implied(const ModelInput* before, const ModelInput* after) const {
    const auto is_alone = [](const ModelPage& page, const std::vector<int>& partners,
                             const ModelInput* input) {
      if (input == nullptr || (input->from < 0 && !input->written)) return true;
      if (input->from < 0) return false;
      const auto from = static_cast<std::size_t>(input->from);
      return partners[from] < 0 && is_component(page.nodes[from]);
    };
    return is_alone(before_, nodes_.to_after, before) && is_alone(after_, nodes_.to_before, after);
  }

  static std::string driver(const ModelPage& page, const ModelInput* input) {
    if (input == nullptr) return "";
    if (input->from >= 0 && active_beside(*input) == nullptr)
      return label_of(page.nodes[static_cast<std::size_t>(input->from)]);
    if (!input->written) return "";
    if (input->role != Role::kFormula || input->written->as.text.empty()) return words_of(*input->written);
    cdl::Expression formula = *input->written;
    formula.as = {};
    return cdl::print(formula);
  }

  void compare_port(const ModelNode& before, const ModelNode& after, const std::string& port,
                    const std::vector<const ModelInput*>& olds, const std::vector<const ModelInput*>& news,
                    Difference& out) {
    const bool is_list = (!olds.empty() && olds.front()->index) || (!news.empty() && news.front()->index);
    if (is_list && (olds.empty() || olds.front()->role != Role::kCase)) {
      compare_list(before, after, port, olds, news, out);
      return;
    }
    const ModelInput* was = olds.empty() ? nullptr : olds.front();
    const ModelInput* is = news.empty() ? nullptr : news.front();
    if (was != nullptr && is != nullptr && is_same(*was, *is)) return;
    if (!is_implied(was, is)) put(out, port, driver(before_, was), driver(after_, is));
  }

  static void put(Difference& out, const std::string& what, std::string before, std::string after) {
    out.details.push_back({what, std::move(before), std::move(after)});
  }

  void compare_list(const ModelNode& before, const ModelNode& after, const std::string& port,
                    const std::vector<const ModelInput*>& olds, const std::vector<const ModelInput*>& news,
                    Difference& out) {
    const Pairs items = match_items(olds, news);
    for (std::size_t i = 0; i < olds.size(); ++i) {
      if (items.to_after[i] >= 0) {
        const auto k = static_cast<std::size_t>(items.to_after[i]);
        if (!is_same(*olds[i], *news[k])) put(out, port, driver(before_, olds[i]), driver(after_, news[k]));
        compare_weights(before, after, *olds[i], *news[k], out);
      } else if (!is_implied(olds[i], nullptr)) {
        put(out, port, driver(before_, olds[i]), "");
      }
    }
    for (std::size_t i = 0; i < news.size(); ++i) {
      if (items.to_before[i] < 0 && !is_implied(nullptr, news[i]))
        put(out, port, "", driver(after_, news[i]));
    }
    if (!items.keep_order()) tell_order(olds, news, items, port, out);
  }

  // By what drives them; a constant also by its place.
  Pairs match_items(const std::vector<const ModelInput*>& olds, const std::vector<const ModelInput*>& news) {
    Pairs out(olds.size(), news.size());
    pair_by(
        out,
        [&](std::size_t i) {
          const int from = olds[i]->from;
          return from < 0 ? 0 : nodes_.to_after[static_cast<std::size_t>(from)] + 1;
        },
        [&](std::size_t i) { return news[i]->from + 1; });
    const auto constant = [](const ModelInput& input, Fingerprints& prints) {
      return input.from >= 0 ? Fingerprints::Print{0} : prints.of(input.written);
    };
    pair_by(
        out, [&](std::size_t i) { return constant(*olds[i], prints_.before); },
        [&](std::size_t i) { return constant(*news[i], prints_.after); });
    const auto place = [](const std::vector<const ModelInput*>& all, std::size_t i) {
      return all[i]->from < 0 ? i + 1 : 0;
    };
    pair_by(
        out, [&](std::size_t i) { return place(olds, i); }, [&](std::size_t i) { return place(news, i); });
    return out;
  }

  static const ModelInput* weight_of(const ModelNode& node, const ModelInput& member) {
    const auto next = static_cast<std::size_t>(&member - node.inputs.data()) + 1;
    const bool is_it =
        member.role == Role::kMember && next < node.inputs.size() && node.inputs[next].role == Role::kWeight;
    return is_it ? &node.inputs[next] : nullptr;
  }

  void compare_weights(const ModelNode& before, const ModelNode& after, const ModelInput& was,
                       const ModelInput& is, Difference& out) {
    const ModelInput* old_weight = weight_of(before, was);
    const ModelInput* new_weight = weight_of(after, is);
    if (old_weight == nullptr || new_weight == nullptr || is_same(*old_weight, *new_weight)) return;
    put(out, "weight of " + driver(after_, &is), driver(before_, old_weight), driver(after_, new_weight));
  }

  void tell_order(const std::vector<const ModelInput*>& olds, const std::vector<const ModelInput*>& news,
                  const Pairs& items, const std::string& port, Difference& out) {
    const auto named = [](const ModelPage& page, const std::vector<const ModelInput*>& all,
                          const std::vector<int>& partners) {
      std::string text;
      std::size_t count = 0;
      for (std::size_t i = 0; i < all.size() && count <= kMostNamed; ++i) {
        if (partners[i] < 0) continue;
        text += (text.empty() ? "" : ", ") + (++count > kMostNamed ? "..." : driver(page, all[i]));
      }
      return text;
    };
    out.details.push_back(
        {"order of " + port, named(before_, olds, items.to_after), named(after_, news, items.to_before)});
  }

  // ---- what the page gives

  void compare_results() {
    if (before_.sequence != nullptr || after_.sequence != nullptr) return;
    const ModelInput was = result_of(before_);
    const ModelInput is = result_of(after_);
    const bool is_wired = was.from >= 0 || is.from >= 0;
    if (is_wired ? is_same(was, is) : hash(before_, prints_.before) == hash(after_, prints_.after)) return;
    const bool has_constant = is_constant(before_) || is_constant(after_);
    if (is_implied(&was, &is) && !has_constant) return;
    Difference one = on_page(Thing::kResult);
    one.kind = "result";
    one.name_before = one.name_after = "$result";
    if (before_.root != nullptr) one.place_before = before_.root->place;
    if (after_.root != nullptr) one.place_after = after_.root->place;
    note(one, "result", result_words(before_), result_words(after_));
    if (settle(one)) out_.meaning.push_back(std::move(one));
  }
  static bool is_constant(const ModelPage& page) { return page.root != nullptr && page.result < 0; }
  static ModelInput result_of(const ModelPage& page) {
    ModelInput out;
    out.from = page.result;
    return out;
  }
  static std::string result_words(const ModelPage& page) {
    if (page.result >= 0) return label_of(page.nodes[static_cast<std::size_t>(page.result)]);
    return page.root == nullptr ? "" : words_of(*page.root);
  }
  static Fingerprints::Print hash(const ModelPage& page, Fingerprints& prints) {
    return page.root == nullptr ? 0 : prints.of(*page.root);
  }

  const ModelPage& before_;
  const ModelPage& after_;
  Prints& prints_;
  Pairs nodes_;
  Comparison& out_;
};

/// All pages of an assemblage or robot.
class OwnerComparison {
 public:
  OwnerComparison(const OwnerModel& before, const OwnerModel& after, const Renames& renames, Comparison& out)
      : before_(before), after_(after), prints_(renames), out_(out) {}

  void run() { compare_pages(0, 0); }

 private:
  const ModelPage& before_page(int at) const { return before_.pages[static_cast<std::size_t>(at)]; }
  const ModelPage& after_page(int at) const { return after_.pages[static_cast<std::size_t>(at)]; }

  void compare_pages(int was, int is) {
    const ModelPage& before = before_page(was);
    const ModelPage& after = after_page(is);
    PageComparison nodes(before, after, prints_, out_);
    nodes.run();
    const std::size_t at = out_.pages.size();
    out_.pages.push_back({before.path, after.path, {}});
    std::vector<std::pair<int, int>> inner;
    const Pairs& pairs = nodes.nodes();
    for (std::size_t i = 0; i < before.nodes.size(); ++i) {
      if (pairs.to_after[i] < 0) continue;
      const ModelNode& one = before.nodes[i];
      const ModelNode& other = after.nodes[static_cast<std::size_t>(pairs.to_after[i])];
      out_.pages[at].names.emplace_back(one.name, other.name);
      if (one.inner >= 0 && other.inner >= 0) inner.emplace_back(one.inner, other.inner);
    }
    compare_states(before, after, at, inner);
    for (const auto& [one, other] : inner) compare_pages(one, other);
  }

  // ---- states

  static Difference on_pages(const ModelPage& before, const ModelPage& after, Thing thing) {
    Difference out;
    out.thing = thing;
    out.page_before = before.path;
    out.page_after = after.path;
    out.kind = thing == Thing::kState ? "state" : "transition";
    return out;
  }

  // One of the two may have no states: then all of the other's came or went.
  void compare_states(const ModelPage& before, const ModelPage& after, std::size_t at,
                      std::vector<std::pair<int, int>>& inner) {
    static const cdl::Sequence kNone;
    const cdl::Sequence& was = before.sequence == nullptr ? kNone : *before.sequence;
    const cdl::Sequence& is = after.sequence == nullptr ? kNone : *after.sequence;
    const Pairs states = match_states(was, is, prints_);
    Renames::Names targets;
    for (std::size_t i = 0; i < was.states.size(); ++i) {
      if (states.to_after[i] < 0) {
        tell_state(before, after, was.states[i], What::kRemoved);
        continue;
      }
      const auto k = static_cast<std::size_t>(states.to_after[i]);
      targets.emplace(was.states[i].name.text, is.states[k].name.text);
      out_.pages[at].names.emplace_back(was.states[i].name.text, is.states[k].name.text);
      inner.emplace_back(before.states[i], after.states[k]);
    }
    for (std::size_t k = 0; k < is.states.size(); ++k) {
      if (states.to_before[k] < 0)
        tell_state(before, after, is.states[k], What::kAdded);
      else
        compare_state(before, after, was.states[static_cast<std::size_t>(states.to_before[k])], is.states[k],
                      targets);
    }
  }

  void tell_state(const ModelPage& before, const ModelPage& after, const cdl::State& state, What what) {
    Difference one = on_pages(before, after, Thing::kState);
    one.what = what;
    (what == What::kAdded ? one.name_after : one.name_before) = state.name.text;
    (what == What::kAdded ? one.place_after : one.place_before) = state.place;
    out_.meaning.push_back(std::move(one));
  }

  void compare_state(const ModelPage& before, const ModelPage& after, const cdl::State& was,
                     const cdl::State& is, const Renames::Names& targets) {
    Difference one = on_pages(before, after, Thing::kState);
    one.name_before = was.name.text;
    one.name_after = is.name.text;
    one.place_before = was.place;
    one.place_after = is.place;
    note(one, "name", was.name.text, is.name.text);
    note(one, "start", was.is_start ? "yes" : "no", is.is_start ? "yes" : "no");
    note(one, "final", was.is_final ? "yes" : "no", is.is_final ? "yes" : "no");
    note(one, "help", was.help, is.help);
    const Pairs transitions = match_transitions(was, is, targets, prints_);
    if (!transitions.keep_order()) tell_order(was, is, transitions, one);
    if (settle(one)) out_.meaning.push_back(std::move(one));
    for (std::size_t i = 0; i < was.transitions.size(); ++i) {
      if (transitions.to_after[i] < 0) tell_transition(before, after, was, i, What::kRemoved);
    }
    for (std::size_t k = 0; k < is.transitions.size(); ++k) {
      if (transitions.to_before[k] < 0)
        tell_transition(before, after, is, k, What::kAdded);
      else
        compare_transition(before, after, was, is, static_cast<std::size_t>(transitions.to_before[k]), k,
                           targets);
    }
  }

  static void tell_order(const cdl::State& was, const cdl::State& is, const Pairs& transitions,
                         Difference& out) {
    const auto named = [](const cdl::State& state, const std::vector<int>& partners) {
      std::string text;
      std::size_t count = 0;
      for (std::size_t i = 0; i < partners.size() && count <= kMostNamed; ++i) {
        if (partners[i] < 0) continue;
        text += (text.empty() ? "to " : ", to ") +
                (++count > kMostNamed ? "..." : state.transitions[i].target.text);
      }
      return text;
    };
    out.details.push_back(
        {"order of transitions", named(was, transitions.to_after), named(is, transitions.to_before)});
  }

  static std::string words(const cdl::Transition& transition) {
    return fmt::format("{} -> {}", transition.trigger ? words_of(*transition.trigger) : "",
                       transition.target.text);
  }

  void tell_transition(const ModelPage& before, const ModelPage& after, const cdl::State& state,
                       std::size_t index, What what) {
    const cdl::Transition& transition = state.transitions[index];
    Difference one = on_pages(before, after, Thing::kTransition);
    one.what = what;
    const bool is_new = what == What::kAdded;
    (is_new ? one.name_after : one.name_before) = state.name.text;
    (is_new ? one.index_after : one.index_before) = static_cast<int>(index);
    (is_new ? one.place_after : one.place_before) = transition.place;
    one.details.push_back({"transition", is_new ? "" : words(transition), is_new ? words(transition) : ""});
    out_.meaning.push_back(std::move(one));
  }

  void compare_transition(const ModelPage& before, const ModelPage& after, const cdl::State& was,
                          const cdl::State& is, std::size_t i, std::size_t k, const Renames::Names& targets) {
    const cdl::Transition& old_one = was.transitions[i];
    const cdl::Transition& new_one = is.transitions[k];
    Difference one = on_pages(before, after, Thing::kTransition);
    one.name_before = was.name.text;
    one.name_after = is.name.text;
    one.index_before = static_cast<int>(i);
    one.index_after = static_cast<int>(k);
    one.place_before = old_one.place;
    one.place_after = new_one.place;
    if (prints_.before.of(old_one.trigger) != prints_.after.of(new_one.trigger))
      one.details.push_back({"trigger", old_one.trigger ? words_of(*old_one.trigger) : "",
                             new_one.trigger ? words_of(*new_one.trigger) : ""});
    if (Renames::in(targets, old_one.target.text) != new_one.target.text)
      one.details.push_back({"goes to", old_one.target.text, new_one.target.text});
    note(one, "restarts", old_one.restarts ? "yes" : "no", new_one.restarts ? "yes" : "no");
    note(one, "help", old_one.help, new_one.help);
    if (!settle(one)) return;
    one.kind = new_one.target.text;
    out_.meaning.push_back(std::move(one));
  }

  const OwnerModel& before_;
  const OwnerModel& after_;
  Prints prints_;
  Comparison& out_;
};

}  // namespace

std::string words_of(const cdl::Expression& expression) {
  const text::Place& place = expression.place;
  return place.source ? std::string(place.source->text(place.span)) : cdl::print(expression);
}

void note(Difference& out, const char* what, std::string before, std::string after) {
  if (before != after) out.details.push_back({what, std::move(before), std::move(after)});
}

bool settle(Difference& out) {
  if (out.details.empty()) return false;
  const bool is_name = out.details.size() == 1 && out.details.front().what == "name";
  out.what = is_name ? What::kRenamed : What::kChanged;
  return true;
}

void compare_owner(const OwnerModel& before, const OwnerModel& after, const Renames& renames,
                   Comparison& out) {
  OwnerComparison(before, after, renames, out).run();
}

}  // namespace mlab::difference
