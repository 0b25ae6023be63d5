// Declarations of a file, and their parameters.

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/editor.h"
#include "mlab/lang/cdl/quantities.h"
#include "mlab/lang/cdl/walk.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

// Help behind a parameter stands on its line.
std::string one_line(std::string help) {
  std::ranges::replace(help, '\n', ' ');
  std::ranges::replace(help, '\r', ' ');
  return help;
}

}  // namespace

std::string type_words(const cdl::PortType& type) {
  const std::string name = type.name();
  if (name == "double" && type.unit == "deg") return "angle [deg]";
  constexpr std::array<std::string_view, 9> kShown = {"number",  "length", "speed", "angle",       "duration",
                                                      "turning", "flag",   "count", "object_class"};
  for (const std::string_view one : kShown) {
    const cdl::Quantity* quantity = cdl::quantity_named(one);
    if (quantity->type == name && quantity->unit == type.unit) return std::string(one);
  }
  if (name == "Text") return "text";
  return type.unit.empty() ? name : fmt::format("{} [{}]", name, type.unit);
}

// ---- declarations

// Before the layout blocks, which are the end of the file; a robot or society goes behind all else.
Done Editor::add_text(const std::string& text) {
  auto at = static_cast<std::uint32_t>(work_.text().size());
  if (!text.starts_with("layout")) {
    for (const cdl::Item& item : work_.model().tree().items) {
      if (const auto* layout = std::get_if<cdl::Layout>(&item)) at = std::min(at, layout->whole.begin);
    }
  }
  const std::string_view before = work_.text().substr(0, at);
  std::string what;
  if (!before.empty() && before.find_first_not_of(" \t\r\n") != std::string_view::npos) {
    const std::size_t end = before.find_last_not_of(" \t\r\n");
    const auto breaks = std::ranges::count(before.substr(end), '\n');
    for (auto i = breaks; i < 2; ++i) what += '\n';
  }
  what += text + "\n";
  if (at < work_.text().size()) what += "\n";
  work_.replace_all({at, at}, what);
  return true;
}

Done Editor::add_declaration(const AddDeclaration& change) {
  const std::string& name = change.name();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  const std::map<std::string, Anchor> all = anchors_of(work_.model(), "", work_.tokens());
  if (all.contains(name)) return refusal(fmt::format("there is a `{}` already", name));
  std::string words;
  if (change.kind() == "assemblage") {
    words = fmt::format("assemblage {}() {{\n}}", name);
  } else if (change.kind() == "robot") {
    words = fmt::format("robot {} {{\n}}", name);
  } else if (change.kind() == "class") {
    words = fmt::format("class {} {{\nbody {{ radius = 0.3 m; }}\n}}", name);
  } else if (change.kind() == "society") {
    const auto& robots = work_.model().configuration().own_robots;
    if (robots.empty()) return refusal("a society needs a robot: add one first");
    words = fmt::format("society {}: team of 3 {};", name, robots.front()->name.text);
  } else {
    return refusal(fmt::format("`{}` is no kind of declaration", text::shown(change.kind())));
  }
  if (const Done done = add_text(words); !done) return done;
  if (const Done done = work_.commit(); !done) return done;
  if (change.x() == 0.0 && change.y() == 0.0) return true;
  Arrange where;
  Arrange::At& at = *where.add_nodes();
  at.set_node(name);
  at.set_x(change.x());
  at.set_y(change.y());
  return arrange(where);
}

Done Editor::remove_declarations(const Remove& change) {
  for (const std::string& name : change.nodes()) {
    const text::Span span = declaration_span(work_.model(), name);
    if (span.end == span.begin) return refusal(fmt::format("there is no `{}`", text::shown(name)));
    // Its own help goes along, and one of the empty lines around it.
    text::Span all = span;
    while (all.begin > 0 && (work_.text()[all.begin - 1] == '\n' || work_.text()[all.begin - 1] == ' '))
      --all.begin;
    if (all.begin > 0 || span.end == work_.text().size()) {
      const TokenMap& tokens = work_.tokens();
      const std::size_t first = tokens.at(span.begin);
      work_.replace_all({all.begin, tokens.tokens()[first].span.begin}, all.begin > 0 ? "\n" : "");
      work_.erase({tokens.tokens()[first].span.begin, span.end});
    } else {
      const TokenMap& tokens = work_.tokens();
      const std::size_t first = tokens.at(span.begin);
      work_.replace_all({span.begin, tokens.tokens()[first].span.begin}, "");
      std::uint32_t end = span.end;
      work_.erase({tokens.tokens()[first].span.begin, end});
      while (end < work_.text().size() && work_.text()[end] == '\n') ++end;
      work_.replace_all({span.end, end}, "");
    }
    if (const Done done = work_.commit(); !done) return done;
  }
  return true;
}

Done Editor::copy_component(const CopyComponent& change) {
  const Model& model = work_.model();
  const auto& configuration = model.configuration();
  text::SourcePtr source;
  const auto look = [&](const auto& table) {
    const auto found = table.find(change.component());
    if (found != table.end()) source = found->second->name.place.source;
  };
  look(configuration.assemblages);
  look(configuration.classes);
  look(configuration.robots);
  look(configuration.operators);
  look(configuration.bindings);
  if (!source)
    return refusal(
        fmt::format("`{}` is no assemblage: only those can be copied", text::shown(change.component())));
  const std::string name = change.name().empty() ? change.component() : change.name();
  if (!is_cdl_name(name)) return refusal(fmt::format("`{}` is no name", text::shown(name)));
  if (anchors_of(model, "", work_.tokens()).contains(name))
    return refusal(fmt::format("there is a `{}` already", name));
  const Model other(source, cdl::Environment{configuration.built_in, nullptr});
  const text::Span span = declaration_span(other, change.component());
  std::string words(source->text(span));
  const std::map<std::string, Anchor> there = anchors_of(other, "", TokenMap(source->text()));
  const std::uint32_t at = there.at(change.component()) - span.begin;
  words.replace(at, change.component().size(), name);
  if (const Done done = add_text(words); !done) return done;
  return work_.commit();
}

// ---- parameters

const std::vector<cdl::Parameter>* Editor::parameters(std::string_view owner, text::Span& name) const {
  const Model& model = work_.model();
  if (const cdl::Assemblage* one = model.assemblage(owner)) {
    name = one->name.place.span;
    return &one->parameters;
  }
  if (const cdl::Robot* one = model.robot(owner)) {
    name = one->name.place.span;
    return &one->parameters;
  }
  if (const cdl::RobotClass* one = model.robot_class(owner)) {
    name = one->name.place.span;
    return &one->parameters;
  }
  return nullptr;
}

Done Editor::set_parameter(const SetParameter& change) {
  text::Span owner;
  const std::vector<cdl::Parameter>* all = parameters(change.owner(), owner);
  if (all == nullptr) return refusal(fmt::format("there is no `{}`", text::shown(change.owner())));
  if (!is_cdl_name(change.name())) return refusal(fmt::format("`{}` is no name", text::shown(change.name())));
  const auto known =
      std::ranges::find_if(*all, [&](const cdl::Parameter& p) { return p.name.text == change.name(); });
  const bool is_new = known == all->end();
  for (const std::string* value : {&change.initial(), &change.low(), &change.high()}) {
    if (!value->empty() && !is_expression(*value))
      return refusal(fmt::format("`{}` is no value", text::shown(*value)));
  }
  if (change.low().empty() != change.high().empty()) return refusal("a range has two ends");
  const auto words_of = [&](const cdl::ExpressionPtr& value) {
    return value ? std::string(work_.text().substr(value->place.span.begin,
                                                   value->place.span.end - value->place.span.begin))
                 : std::string();
  };
  const auto number = [](const std::optional<cdl::Number>& value) {
    if (!value) return std::string();
    return value->unit.text.empty() ? fmt::format("{}", value->value)
                                    : fmt::format("{} {}", value->value, value->unit.text);
  };
  // What is not said of a known one stays.
  std::string type = change.type();
  std::string initial = change.initial();
  std::string low = change.low();
  std::string high = change.high();
  if (!is_new && type.empty()) {
    type = known->type.text + (known->unit.text.empty() ? "" : fmt::format(" [{}]", known->unit.text));
    if (initial.empty()) initial = words_of(known->initial);
    if (low.empty()) low = number(known->low);
    if (high.empty()) high = number(known->high);
  }
  if (type.empty()) return refusal("a parameter has a type");
  std::string words = fmt::format("{}: {}", change.name(), type);
  if (!initial.empty()) words += " = " + initial;
  if (!low.empty()) words += fmt::format(" in {} .. {}", low, high);
  const std::string help = one_line(change.help());
  const TokenMap& tokens = work_.tokens();
  if (!is_new) {
    const text::Span span = known->whole;
    work_.replace({known->name.place.span.begin, span.end},
                  Fragment(work_.moved(known->name.place.span)).add(words.substr(change.name().size())));
    if (change.type().empty() ? !help.empty() : help != known->help) {
      // `///<` behind the parameter, or behind its comma.
      std::uint32_t behind = span.end;
      if (tokens.word(tokens.at(behind)) == ",") behind = tokens.tokens()[tokens.at(behind)].span.end;
      const std::size_t next = tokens.at(behind);
      for (std::uint32_t i = tokens.tokens()[next - 1].comments; i < tokens.tokens()[next].comments; ++i) {
        const text::Span comment = tokens.comments()[i].span;
        if (work_.text().substr(comment.begin).starts_with("///<")) work_.replace_all(comment, "");
      }
      if (!help.empty()) work_.insert(behind, fmt::format("  ///< {}\n", help));
    }
    return work_.commit();
  }
  if (!all->empty()) {
    const text::Span last = all->back().whole;
    const std::string tail = help.empty() ? "" : fmt::format("  ///< {}\n", help);
    // Help behind the last one stays its own.
    const std::size_t close = tokens.at(last.end);
    bool has_comment = false;
    std::uint32_t comment_end = last.end;
    for (std::uint32_t i = tokens.tokens()[close - 1].comments; i < tokens.tokens()[close].comments; ++i) {
      has_comment = true;
      comment_end = tokens.comments()[i].span.end;
    }
    if (has_comment) {
      work_.insert(last.end, ",");
      work_.insert(comment_end, "\n" + words + tail);
    } else {
      work_.insert(last.end, ", " + words + tail);
    }
    return work_.commit();
  }
  const std::string tail = help.empty() ? "" : fmt::format("  ///< {}\n", help);
  const std::size_t open = tokens.at(owner.end);
  if (tokens.word(open) == "(")
    work_.insert(tokens.tokens()[open].span.end, words + tail);
  else
    work_.insert(owner.end, fmt::format("({}{})", words, tail));
  return work_.commit();
}

// What read it gets its default, and who gave it gives it no more.
Done Editor::remove_parameter(const RemoveParameter& change) {
  text::Span owner;
  const std::vector<cdl::Parameter>* all = parameters(change.owner(), owner);
  if (all == nullptr) return refusal(fmt::format("there is no `{}`", text::shown(change.owner())));
  const auto known =
      std::ranges::find_if(*all, [&](const cdl::Parameter& p) { return p.name.text == change.name(); });
  if (known == all->end())
    return refusal(fmt::format("there is no parameter `{}`", text::shown(change.name())));
  const bool is_class = work_.model().robot_class(change.owner()) != nullptr;
  if (const OwnerGraph* graph = is_class ? nullptr : work_.model().graph(change.owner())) {
    for (const GraphPage& page : graph->pages) {
      for (std::size_t i = 0; i < page.nodes.size(); ++i) {
        for (std::size_t k = 0; k < page.nodes[i].inputs.size(); ++k) {
          const GraphInput& input = page.nodes[i].inputs[k];
          const auto* reads = input.written ? std::get_if<cdl::Name>(&input.written->what) : nullptr;
          if (reads == nullptr || reads->name.text != change.name()) continue;
          const Spot spot{{graph, &page}, static_cast<int>(i), static_cast<int>(k), ""};
          const std::string initial =
              known->initial ? std::string(work_.text().substr(
                                   known->initial->place.span.begin,
                                   known->initial->place.span.end - known->initial->place.span.begin))
                             : "";
          const Done done = initial.empty() ? clear(spot) : write(spot, initial);
          if (!done) return done;
          if (const Done committed = work_.commit(); !committed) return committed;
          return remove_parameter(change);
        }
      }
    }
    if (count_uses(*graph, change.name()) > 0)
      return refusal(fmt::format("a trigger or another parameter needs `{}`", change.name()));
  }
  const TokenMap& tokens = work_.tokens();
  const text::Span span = known->whole;
  const std::size_t after = tokens.at(span.end);
  const std::size_t before = tokens.at(span.begin) - 1;
  if (tokens.word(after) == ",")
    work_.erase({span.begin, tokens.tokens()[after + 1].span.begin});
  else if (tokens.word(before) == ",")
    work_.erase({tokens.tokens()[before].span.begin, span.end});
  else
    work_.erase(span);
  const auto forget = [&](const cdl::ExpressionPtr& expression) {
    if (!expression) return;
    cdl::for_each_expression(*expression, [&](const cdl::Expression& one) {
      const auto* call = std::get_if<cdl::Call>(&one.what);
      if (call == nullptr || call->callee.text != change.owner()) return;
      for (std::size_t i = 0; i < call->arguments.size(); ++i) {
        const cdl::Argument& argument = call->arguments[i];
        if (argument.name.text != change.name()) continue;
        const text::Span whole{argument.name.place.span.begin, argument.value->place.span.end};
        const std::size_t behind = tokens.at(whole.end);
        const std::size_t ahead = tokens.at(whole.begin) - 1;
        if (tokens.word(behind) == ",")
          work_.erase({whole.begin, tokens.tokens()[behind + 1].span.begin});
        else if (tokens.word(ahead) == ",")
          work_.erase({tokens.tokens()[ahead].span.begin, whole.end});
        else
          work_.erase(whole);
      }
    });
  };
  for (const cdl::Item& item : work_.model().tree().items) {
    if (const auto* assemblage = std::get_if<cdl::Assemblage>(&item)) {
      for (const cdl::Let& let : assemblage->lets) forget(let.value);
      forget(assemblage->body);
    } else if (const auto* robot = std::get_if<cdl::Robot>(&item)) {
      for (const cdl::Let& let : robot->lets) forget(let.value);
      for (const cdl::Drive& drive : robot->drives) forget(drive.value);
    }
  }
  return work_.commit();
}

}  // namespace mlab::designer
