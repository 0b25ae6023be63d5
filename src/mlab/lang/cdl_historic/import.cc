#include "mlab/lang/cdl_historic/import.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl_historic/converter.h"
#include "mlab/lang/cdl_historic/library_names.h"
#include "mlab/lang/cdl_historic/parser.h"
#include "mlab/lang/cdl_historic/robots.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

// `path/old.cdl` without path and ending.
std::string stem(std::string_view path) {
  path = path.substr(path.find_last_of("/\\") + 1);
  path = path.substr(0, path.find('.'));
  return legal_name(path);
}

/// Puts the parts of the result together.
class Import {
 public:
  Import(const Tree& tree, const Vocabulary& vocabulary, text::Diagnostics& sink)
      : tree_(tree),
        sink_(sink),
        converter_(tree, vocabulary, sink),
        robots_(converter_, stem(tree.source->name())) {}

  cdl::Tree run() {
    if (!tree_.expressions.empty()) add_configuration(*tree_.expressions.back());
    add_the_rest();
    return put_together();
  }

 private:
  void add_configuration(const Expr& root) {
    robots_.add_configuration(root);
    converter_.mark_used(&root);
    for (const Expr* other : robots_.others()) {
      if (!robots_.robots().empty()) {
        sink_.warning("not-a-robot", other->place,
                      "this part of the configuration belongs to no robot; it is left as an assemblage");
      }
      add_assemblage(*other, name_of(root));
    }
  }

  std::string name_of(const Expr& root) const {
    const bool is_named = !root.inline_names.empty() && !root.inline_names[0].text.starts_with('$') &&
                          root.inline_names[0].text != "NoName";
    return is_named ? root.inline_names[0].text : stem(tree_.source->name());
  }

  // What has a name and was not needed so far, what others use last: it comes in with them.
  void add_the_rest() {
    for (const bool is_used_by_others : {false, true}) {
      for (const Instance& instance : tree_.instances) {
        const Symbol* symbol = converter_.symbols().find(instance.name);
        const bool is_used = symbol != nullptr && symbol->expr == instance.what.get() && symbol->uses > 0;
        if (is_used == is_used_by_others) add_unreached(instance);
      }
      if (is_used_by_others) continue;
      for (const ExprPtr& expr : tree_.expressions) {
        if (!converter_.was_used(expr.get())) add_assemblage(*expr, name_of(*expr));
      }
    }
  }

  void add_unreached(const Instance& instance) {
    if (converter_.was_used(instance.what.get())) return;
    using enum Instance::Kind;
    switch (instance.kind) {
      case kAgent:
      case kOperator:
      case kGroup:
        add_assemblage(*instance.what, instance.name.text);
        return;
      case kRobot:
        sink_.warning(
            "not-in-configuration", instance.name.place,
            fmt::format("the configuration does not name the robot `{}`", text::shown(instance.name.text)));
        robots_.add(*instance.what, instance.spot);
        return;
      case kBindingPoint: {
        const std::string& point = instance.what->name.text;
        const Expr* device = converter_.bound_device(*instance.what);
        const bool is_robot =
            point == "vehicle" || (device != nullptr && !robot_class_named(device->name.text).empty());
        if (!is_robot && point != "movement") return;
        sink_.warning("not-in-configuration", instance.name.place,
                      fmt::format("the configuration does not name `{}`", text::shown(instance.name.text)));
        robots_.add(*instance.what, instance.spot);
        return;
      }
      case kSensor:
      case kActuator:
        return;
    }
  }

  // An expression by itself. A state machine is an assemblage already.
  void add_assemblage(const Expr& expr, const std::string& name) {
    Unit unit;
    converter_.start(unit);
    converter_.suggest(name);
    TypedDraft made = converter_.make(expr, nullptr, "");
    converter_.finish(unit);
    if (made.expr == nullptr || made.type.empty()) return;
    const auto* called = std::get_if<cdl::Call>(&made.expr->what);
    const bool is_own = called != nullptr && called->arguments.empty() &&
                        std::ranges::any_of(converter_.assemblages(), [&](const cdl::Assemblage& a) {
                          return a.name.text == called->callee.text;
                        });
    if (is_own && unit.lets.empty()) return;
    cdl::Assemblage assemblage;
    assemblage.name = {converter_.free_name(name), expr.place};
    assemblage.help = help_text(expr.spot.label.text);
    assemblage.lets = std::move(unit.lets);
    made.expr->as = {};
    assemblage.body = made.expr;
    converter_.add_assemblage(std::move(assemblage), {});
  }

  cdl::Tree put_together() {
    cdl::Tree out;
    if (converter_.architecture() == kUgv) out.items.emplace_back(cdl::Architecture{{"UGV", {}}});
    for (cdl::Assemblage& hole : converter_.holes().declarations()) out.items.emplace_back(std::move(hole));
    for (cdl::Assemblage& assemblage : converter_.assemblages())
      out.items.emplace_back(std::move(assemblage));
    for (cdl::Robot& robot : robots_.robots()) out.items.emplace_back(std::move(robot));
    for (cdl::Society& society : robots_.societies()) out.items.emplace_back(std::move(society));
    for (const Drawing& drawing : converter_.drawings()) {
      if (!drawing.nodes.empty()) out.items.emplace_back(laid_out(drawing));
    }
    if (out.items.empty()) {
      sink_.warning("nothing-in-it", {tree_.source, {0, 0}},
                    "this file holds neither a robot nor an assemblage");
    }
    return out;
  }

  const Tree& tree_;
  text::Diagnostics& sink_;
  Converter converter_;
  Robots robots_;
};

}  // namespace

cdl::Tree import(const text::SourcePtr& source, const Vocabulary& vocabulary, text::Diagnostics& sink) {
  const Tree tree = parse(source, sink);
  return Import(tree, vocabulary, sink).run();
}

std::string import_as_text(const text::SourcePtr& source, const Vocabulary& vocabulary,
                           text::Diagnostics& sink) {
  const cdl::Tree tree = import(source, vocabulary, sink);
  std::string_view path = source->name();
  path = path.substr(path.find_last_of("/\\") + 1);
  std::string out = fmt::format("// From `{}`, a configuration of the historic tools.\n", text::shown(path));
  std::string empty;
  for (const cdl::Item& item : tree.items) {
    const auto* assemblage = std::get_if<cdl::Assemblage>(&item);
    if (assemblage != nullptr && assemblage->body == nullptr) empty += "//   " + assemblage->name.text + "\n";
  }
  if (!empty.empty()) out += "// Declared and empty, because nothing here answers to it:\n" + empty;
  return out + "\n" + cdl::print(tree);
}

bool looks_historic(std::string_view text) {
  constexpr std::string_view kWords[] = {"instBP",    "instbp",    "instGroup", "instgroup",
                                         "instAgent", "instagent", "bindArch",  "bindarch",
                                         "defAgent",  "defagent",  "defType",   "deftype"};
  return std::ranges::any_of(
      kWords, [text](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

}  // namespace mlab::cdl_historic
