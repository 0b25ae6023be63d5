#include "mlab/lang/cdl_historic/converter.h"

#include <algorithm>

#include <fmt/core.h>

#include "mlab/lang/cdl_historic/constants.h"
#include "mlab/lang/cdl_historic/library_names.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

// Of instances in instances, references followed. Each may become a call in a list in a call: four levels of
// our language, which allows cdl::kMaxNesting.
constexpr int kMaxDepth = 45;
constexpr std::uint32_t kMaxMade = 400'000;  // a shared part is made anew for each set of values it gets
constexpr std::size_t kMaxDrawn = 2000;      // nodes of one drawing; more are laid out automatically

bool is_anonymous(std::string_view name) {
  return name.starts_with('$') || name.starts_with("AN_");
}

}  // namespace

Converter::Converter(const Tree& tree, const Vocabulary& vocabulary, text::Diagnostics& sink)
    : tree_(tree), vocabulary_(vocabulary), sink_(sink), symbols_(tree) {
  if (!tree.architectures.empty()) {
    const Word& bound = tree.architectures.back();
    architecture_ = architecture_named(bound.text);
    const bool is_own =
        std::ranges::any_of(tree.own_architectures, [&](const Word& own) { return own.text == bound.text; });
    if (architecture_ == 0 && bound.text != "free" && !is_own) {
      sink.warning("unknown-architecture", bound.place,
                   fmt::format("no architecture `{}` is known; names are looked for in all of them",
                               text::shown(bound.text)));
    }
  }
  for (const NamedValue& value : tree.named_values) named_values_[value.name.text] = value.value.text;
}

const Level* Converter::level(const Level* outer, const std::vector<Setting>& settings) {
  const auto [it, is_new] = settings_.try_emplace(&settings);
  if (is_new) it->second = by_name(settings);
  return &levels_.emplace_back(Level{outer, &it->second});
}

Word Converter::with_names(const Word& constant) const {
  return named_values_.empty() ? constant
                               : Word{with_named_values(constant.text, named_values_), constant.place};
}

void Converter::warn_once(std::string kind, const std::string& key, text::Place place, std::string message) {
  if (warned_.insert(kind + " " + key).second)
    sink_.warning(std::move(kind), std::move(place), std::move(message));
}

std::string Converter::free_name(std::string_view wanted) {
  const std::string base = legal_name(wanted);
  std::string name = base;
  for (int n = 2; vocabulary_.is_taken(name) || !top_names_.insert(name).second; ++n)
    name = fmt::format("{}_{}", base, n);
  return name;
}

std::string Converter::add_assemblage(cdl::Assemblage assemblage, std::vector<Node> nodes) {
  if (nodes.size() > kMaxDrawn) nodes.clear();
  // Two robots may use one named state machine.
  std::string print = fmt::format("{}:", assemblage.name.place.span.begin);
  for (const cdl::Let& let : assemblage.lets) print += let.name.text + "=" + fingerprint(*let.value) + ";";
  print += fingerprint(*assemblage.body);
  for (const Node& node : nodes) print += fmt::format("{} {} {};", node.name, node.x, node.y);
  const auto [it, is_new] = assemblage_by_fingerprint_.emplace(print, assemblage.name.text);
  if (!is_new) return it->second;
  if (!nodes.empty()) drawings_.push_back({assemblage.name.text, std::move(nodes)});
  assemblages_.push_back(std::move(assemblage));
  return it->second;
}

const Definition* Converter::definition(std::string_view name) const {
  for (const Definition& d : tree_.definitions) {
    if (d.name.text == name) return &d;
  }
  return nullptr;
}

std::string Converter::operator_style(std::string_view name) const {
  if (name == "FSA") return "FSAstyle";
  if (name == "MDL_coordinator" || name == "EXECUTIVE") return "MDLstyle";
  const Definition* own = definition(name);
  return own == nullptr ? std::string{} : own->style.text;
}

TypedDraft Converter::make(const Expr& expr, const Level* level, std::string_view wanted) {
  made_ += 1 + static_cast<std::uint32_t>(expr.settings.size() / 16);
  if (made_ > kMaxMade && !is_too_large_) {
    is_too_large_ = true;
    sink_.error("too-large", expr.place, "written out, the parts that this configuration shares are too many")
        .hints = {"a part that several others use with different values is written once for each"};
  }
  if (is_too_large_) return nothing(wanted, expr.place);
  if (depth_ >= kMaxDepth) {
    warn_once("nested-too-deeply", "", expr.place,
              fmt::format("parts are nested more than {} deep; the rest is left out", kMaxDepth));
    return nothing(wanted, expr.place);
  }
  ++depth_;
  used_.insert(&expr);
  TypedDraft made;
  const Symbol* symbol = expr.inline_names.empty() || expr.kind == Expr::Kind::kReference
                             ? nullptr
                             : symbols_.find(expr.inline_names[0]);
  if (symbol != nullptr && symbol->expr == &expr && symbol->uses > 0 && !open_.contains(&expr)) {
    made = make_shared(*symbol, level, wanted, expr.place);
  } else {
    made = make_bare(expr, level, wanted);
    name_node(expr, made);
  }
  --depth_;
  return made;
}

// A name that the author gave, on a node that has none yet.
void Converter::name_node(const Expr& expr, TypedDraft& made) {
  if (made.expr == nullptr || expr.inline_names.empty() || units_.empty() || !made.expr->as.text.empty())
    return;
  if (is_anonymous(expr.inline_names[0].text)) return;
  if (!std::holds_alternative<cdl::Call>(made.expr->what) &&
      !std::holds_alternative<cdl::Cooperate>(made.expr->what))
    return;
  const std::string name = legal_name(expr.inline_names[0].text);
  const auto* called = std::get_if<cdl::Call>(&made.expr->what);
  if (called != nullptr && called->callee.text == name) return;  // it is called so anyway
  if (units_.back()->names.insert(name).second) made.expr->as = {name, expr.inline_names[0].place};
}

TypedDraft Converter::make_bare(const Expr& expr, const Level* outer, std::string_view wanted) {
  switch (expr.kind) {
    case Expr::Kind::kGroup:
      return make_members(expr.settings, outer, wanted, expr.place);
    case Expr::Kind::kReference:
      return make_reference(expr, outer, wanted);
    case Expr::Kind::kInstance:
      return make_instance(expr, outer, wanted);
  }
  return {};
}

// A group stands for its only member; of several, for the only one that has a value.
TypedDraft Converter::make_members(const std::vector<Setting>& members, const Level* outer,
                                   std::string_view wanted, const text::Place& place) {
  const Level* own = level(outer, members);
  TypedDraft first;
  for (const Setting& member : members) {
    if (member.value.expr == nullptr || !member.name.text.empty()) continue;
    TypedDraft made = make(*member.value.expr, own, wanted);
    if (made.expr == nullptr || made.type.empty()) continue;
    if (first.expr != nullptr) {
      warn_once("several-members", "", member.value.expr->place,
                "a group stands for one value; the others are left out");
      break;
    }
    first = std::move(made);
  }
  if (first.expr != nullptr) return first;
  warn_once("empty-group", fmt::format("{}", place.span.begin), place,
            "this group holds nothing that has a value");
  return nothing(wanted, place);
}

TypedDraft Converter::nothing(std::string_view type, const text::Place& place) {
  if (type.empty() || type == "Vector") {
    if (vocabulary_.find("Stand") != nullptr) return {call("Stand", place), "Vector"};
    return make_hole("NOOP", "Vector", {}, place);
  }
  if (type == "bool") return {name("false", place), "bool"};
  if (type == "double" || type == "int") return {number(0.0, "", place), std::string(type)};
  if (type == "Text") return {quoted("", place), "Text"};
  if (type == "ObjectClasses") return {quoted("0", place), "ObjectClasses"};
  if (type == "Point") {
    return {draft(cdl::List{{number(0.0, "", place), number(0.0, "", place)}}, place), "Point"};
  }
  const std::string empty = type == "Pose" ? "ZeroPose" : fmt::format("No{}", type);
  if (vocabulary_.find(empty) != nullptr) return {call(empty, place), std::string(type)};
  return make_hole(empty, std::string(type), {}, place);
}

}  // namespace mlab::cdl_historic
