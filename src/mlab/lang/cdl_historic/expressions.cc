// References, library names, calls of procedures, constants.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/types/units.h"
#include "mlab/lang/cdl_historic/constants.h"
#include "mlab/lang/cdl_historic/converter.h"
#include "mlab/lang/cdl_historic/library_names.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

bool is_device(const Symbol& symbol) {
  if (symbol.instance == nullptr) return false;
  using enum Instance::Kind;
  const Instance::Kind kind = symbol.instance->kind;
  return kind == kBindingPoint || kind == kSensor || kind == kActuator || kind == kRobot;
}

// What reads a binding point that nothing occupies.
std::string_view usual_device(std::string_view binding_point) {
  struct Usual {
    std::string_view binding_point;
    std::string_view device;
  };
  static constexpr Usual kUsual[] = {
      {"sense_location", "GET_LOCATION"},       {"localization", "GET_LOCATION"},
      {"sense_compass", "GET_COMPASS_HEADING"}, {"sense_raw_sonar", "RAW_ULTRASONICS"},
      {"sense_obstacles", "DETECT_OBSTACLES"},  {"sense_objects", "DETECT_OBJECTS"}};
  for (const Usual& usual : kUsual) {
    if (usual.binding_point == binding_point) return usual.device;
  }
  return binding_point;
}

// Two names that differ only in letter case and `_`.
bool is_alike(std::string_view a, std::string_view b) {
  const auto fold = [](std::string_view text) {
    std::string out;
    for (const char c : text) {
      if (c != '_') out += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    }
    return out;
  };
  return fold(a) == fold(b);
}

// Which of our parameters a historic one is; null: none.
const Port* port_for(const Signature& ours, const LibraryPort& listed) {
  for (std::string_view rest = listed.ours; !rest.empty();) {
    if (const Port* port = ours.find(next_name(rest))) return port;
  }
  for (const Port& port : ours.ports) {
    if (!listed.historic.empty() && is_alike(port.name, listed.historic)) return &port;
  }
  return nullptr;
}

}  // namespace

const Expr* Converter::bound_device(const Expr& binding_point) const {
  for (const Setting& setting : binding_point.settings) {
    if (setting.name.text != "bound_to" || setting.value.expr == nullptr) continue;
    const Expr* device = setting.value.expr.get();
    if (device->kind != Expr::Kind::kReference) return device;
    const Symbol* symbol = symbols_.find(device->name);
    return symbol == nullptr ? nullptr : symbol->expr;
  }
  return nullptr;
}

TypedDraft Converter::make_reference(const Expr& expr, const Level* outer, std::string_view wanted) {
  const Symbol* symbol = symbols_.find(expr.name);
  if (symbol == nullptr) {
    // A class without its parentheses, where no component of the libraries has the name.
    const HistoricSignature* historic = vocabulary_.find_historic(expr.name.text);
    if (historic != nullptr && library_name(expr.name.text, architecture_) == nullptr &&
        vocabulary_.find_assemblage(expr.name.text) == nullptr)
      return fitting(make_call(expr, *historic, outer), wanted, expr.name.place);
    return make_library(expr.name.text, outer, wanted, expr.name.place);
  }
  if (is_device(*symbol)) return make_sensor(*symbol, outer, wanted);
  return make_shared(*symbol, outer, wanted, expr.name.place);
}

TypedDraft Converter::make_sensor(const Symbol& symbol, const Level* outer, std::string_view wanted) {
  used_.insert(symbol.expr);
  if (symbol.instance->kind != Instance::Kind::kBindingPoint)
    return make_instance(*symbol.expr, outer, wanted);
  const Expr* device = bound_device(*symbol.expr);
  if (device != nullptr && device != symbol.expr) return make(*device, outer, wanted);
  const Expr& point = *symbol.expr;
  const HistoricSignature* usual = vocabulary_.find_historic(usual_device(point.name.text));
  const Level* own = level(outer, point.settings);
  return usual == nullptr ? make_instance_hole(point, own, wanted) : make_call(point, *usual, own);
}

// The assemblage that claims the historic name, else the first of our names that there is and that needs
// nothing which the historic one cannot give.
const Signature* Converter::library_signature(std::string_view name, const LibraryName* row) const {
  if (const Signature* aliased = vocabulary_.find_assemblage(name)) return aliased;
  for (std::string_view rest = row == nullptr ? name : row->ours; !rest.empty();) {
    const Signature* ours = vocabulary_.find(next_name(rest));
    if (ours == nullptr) continue;
    const bool is_fed = std::ranges::all_of(ours->ports, [&](const Port& port) {
      return !port.needs_value ||
             (row != nullptr && std::ranges::any_of(row->ports, [&](const LibraryPort& listed) {
                return port_for(*ours, listed) == &port;
              }));
    });
    if (is_fed) return ours;
  }
  return nullptr;
}

TypedDraft Converter::call_library(const Signature& ours, const LibraryName& row, const Level* outer,
                                   const text::Place& place) {
  std::vector<cdl::Argument> arguments;
  for (const LibraryPort& listed : row.ports) {
    const Port* port = port_for(ours, listed);
    const auto is_same = [&](const cdl::Argument& given) {
      return port != nullptr && given.name.text == port->name;
    };
    std::optional<BoundValue> found;
    if (!listed.historic.empty()) found = look_up(outer, listed.historic, true);
    if (port == nullptr || std::ranges::any_of(arguments, is_same)) {
      if (found && port == nullptr && listed.ours != kOnScreen) {
        warn_once("lost-parameter", fmt::format("{} {}", row.historic, listed.historic), place,
                  fmt::format("`{}` takes no `{}`; it is left out", ours.name, listed.historic));
      }
      continue;
    }
    // The historic libraries counted angles in degrees.
    const std::string unit = port->unit == "rad" ? "deg" : "";
    TypedDraft value = found ? make_from(*found, *port, unit, place) : TypedDraft{};
    if (!found && !listed.initial.empty()) {
      value = make_constant({std::string(listed.initial), place}, *port, unit);
      const bool is_ours = value.expr != nullptr && port->initial != nullptr &&
                           fingerprint(*value.expr) == fingerprint(*port->initial);
      if (is_ours) continue;
    }
    if (value.expr == nullptr && port->needs_value) value = nothing(port->type, place);
    if (value.expr != nullptr) arguments.push_back({{port->name, place}, value.expr});
  }
  return {call(ours.name, place, std::move(arguments)), ours.result};
}

// A name that the table does not know, but the library does: parameters of the same names.
TypedDraft Converter::call_alike(const Signature& ours, const Level* outer, const text::Place& place) {
  std::vector<cdl::Argument> arguments;
  for (const Port& port : ours.ports) {
    TypedDraft value;
    if (outer != nullptr && !port.is_list) {
      for (const auto& [given, settings] : *outer->settings) {
        const std::optional<BoundValue> found =
            is_alike(given, port.name) ? look_up(outer, given, true) : std::nullopt;
        if (found && value.expr == nullptr) value = make_from(*found, port, "", place);
      }
    }
    if (value.expr == nullptr && port.needs_value) value = nothing(port.type, place);
    if (value.expr != nullptr) arguments.push_back({{port.name, place}, value.expr});
  }
  return {call(ours.name, place, std::move(arguments)), ours.result};
}

TypedDraft Converter::make_library(std::string_view name, const Level* outer, std::string_view wanted,
                                   const text::Place& place) {
  const LibraryName* row = library_name(name, architecture_);
  if (const Signature* ours = library_signature(name, row)) {
    const TypedDraft made =
        row == nullptr ? call_alike(*ours, outer, place) : call_library(*ours, *row, outer, place);
    return fitting(made, wanted, place);
  }
  std::vector<Holes::HoleArgument> given;
  if (outer != nullptr) {
    for (const auto& [pushed, settings] : *outer->settings) {
      if (!settings[0]->is_pushed) continue;
      const std::optional<BoundValue> found = look_up(outer, pushed, true);
      if (!found) continue;
      if (found->joined) {
        given.push_back({pushed, {*found->joined, place}, {}});
      } else if (found->value->kind == Value::Kind::kConstant) {
        given.push_back({pushed, with_names(found->value->constant), {}});
      } else if (found->value->kind == Value::Kind::kExpr && found->value->expr != nullptr) {
        TypedDraft made = make(*found->value->expr, found->level, "");
        if (made.expr != nullptr && !made.type.empty()) given.push_back({pushed, {}, std::move(made)});
      }
    }
  }
  std::string type(wanted);
  if (row != nullptr && !row->type.empty()) type = row->type;
  return make_hole(std::string(name), type.empty() ? "Vector" : type, std::move(given), place);
}

TypedDraft Converter::make_hole(const std::string& historic, const std::string& type,
                                std::vector<Holes::HoleArgument> given, const text::Place& place) {
  const std::string free = holes_.knows(historic, type, given) ? std::string{} : free_name(historic);
  warn_once("no-counterpart", historic, place,
            fmt::format("nothing here answers to `{}`; it is declared as an empty assemblage",
                        text::shown(historic)));
  return holes_.use(historic, type, std::move(given), place, free);
}

TypedDraft Converter::make_from(const BoundValue& found, const Port& port, const std::string& unit,
                                const text::Place& place) {
  if (found.joined) return make_constant({*found.joined, place}, port, unit);
  const Value& value = *found.value;
  if (value.kind == Value::Kind::kConstant) return make_constant(value.constant, port, unit);
  if (value.kind == Value::Kind::kExpr && value.expr != nullptr) {
    return fitting(make(*value.expr, found.level, port.type), port.type, value.place);
  }
  return {};
}

TypedDraft Converter::make_value(const Setting& setting, const Level* own, const Port& port,
                                 const std::string& unit) {
  const Value& value = setting.value;
  if (value.kind == Value::Kind::kPushedUp) {
    const std::optional<BoundValue> found = look_up(own, value.up, setting.name.text);
    if (found) return make_from(*found, port, unit, value.place);
    sink_.warning(
        "nobody-sets", value.place,
        fmt::format("no group around this sets `%{}`",
                    text::shown(value.up.name.text.empty() ? setting.name.text : value.up.name.text)));
    return {};
  }
  if (value.kind == Value::Kind::kList) {
    const Level* inner = level(own, value.list);
    for (const Setting& element : value.list) {
      if (element.name.text.empty()) return make_value(element, inner, port, unit);
    }
    return {};
  }
  return make_from({&value, own, std::nullopt}, port, unit, value.place);
}

TypedDraft Converter::make_constant(const Word& said, const Port& port, const std::string& unit) {
  const Word text = with_names(said);
  const std::string& counted_in = unit.empty() ? port.unit : unit;
  if (const Draft value = constant(text, port.type, counted_in)) {
    if (auto* cut = std::get_if<cdl::Text>(&value->what);
        cut != nullptr && cut->value.size() > kMaxTextBytes) {
      cut->value.resize(kMaxTextBytes);
      warn_once("text-too-long", cut->value, text.place,
                fmt::format("a text holds {} bytes; the rest is left out", kMaxTextBytes));
    }
    if (auto* number = std::get_if<cdl::Number>(&value->what)) keep_in_range(*number, port, text);
    return {value, port.type};
  }
  if (port.type == "ObjectClasses") {
    warn_once("unknown-object-class", text.text, text.place,
              fmt::format("no class of objects here is called `{}`; `Unknown` stands in its place",
                          text::shown(text.text)));
    return {name("Unknown", text.place), port.type};
  }
  warn_once(
      "odd-constant", text.text + " " + port.type, text.place,
      fmt::format("`{}` is no value of the type {}; it is left out", text::shown(text.text), port.type));
  return {};
}

// A value out of range would be an error in our language.
void Converter::keep_in_range(cdl::Number& number, const Port& port, const Word& said) {
  const auto ours = cdl::unit_named(port.unit);
  const auto its = cdl::unit_named(number.unit.text);
  if (!ours || !its) return;
  const double value = cdl::converted(number.value, *its, *ours).value_or(number.value);
  if (value >= port.min && value <= port.max) return;
  number.value = std::clamp(value, port.min, port.max);
  number.unit.text = port.unit;
  warn_once("out-of-range", said.text + " " + port.name, said.place,
            fmt::format("`{}` takes {} .. {}{}{}; the nearest stands in the place of `{}`", port.name,
                        port.min, port.max, port.unit.empty() ? "" : " ", port.unit, text::shown(said.text)));
}

// A value where another type is wanted would be an error in our language.
TypedDraft Converter::fitting(TypedDraft made, std::string_view type, const text::Place& place) {
  if (made.expr == nullptr || made.type == type || type.empty()) return made;
  if (made.type == "int" && type == "double") return made;
  warn_once("type-differs", made.type + " " + std::string(type), place,
            fmt::format("this gives {} where {} is wanted; it is left out",
                        made.type.empty() ? "nothing" : made.type, type));
  return nothing(type, place);
}

// --- instances

TypedDraft Converter::make_instance(const Expr& expr, const Level* outer, std::string_view wanted) {
  const Level* own = level(outer, expr.settings);
  const std::string& name = expr.name.text;
  const std::string style = operator_style(name);
  if (style == "FSAstyle") return make_state_machine(expr, own, wanted);
  if (style == "MDLstyle" && name != "EXECUTIVE") return make_console_operator(expr, own);
  if (name == "COOP") return make_cooperation(expr, own);
  if (name == "AND" || name == "OR" || name == "NOT") return make_logic(expr, own);
  if (name.starts_with("DATABASE_")) return make_blackboard(expr, own);
  if (const Expr* device = bound_device(expr); device != nullptr && device != &expr)
    return make(*device, outer, wanted);
  const HistoricSignature* historic = vocabulary_.find_historic(name);
  if (historic != nullptr) return make_call(expr, *historic, own);
  if (library_name(name, architecture_) != nullptr && expr.settings.empty())
    return make_library(name, outer, wanted, expr.name.place);
  return make_instance_hole(expr, own, wanted);
}

TypedDraft Converter::make_call(const Expr& expr, const HistoricSignature& historic, const Level* own) {
  std::vector<cdl::Argument> arguments;
  for (const Port& port : historic.signature->ports) {
    TypedDraft value =
        port.is_list ? make_list(expr, historic, port, own) : make_argument(expr, historic, port, own);
    if (value.expr == nullptr && port.needs_value) {
      warn_once("missing-parameter", expr.name.text + " " + port.name, expr.name.place,
                fmt::format("`{}` needs `{}`, which nothing sets", text::shown(expr.name.text), port.name));
      value = nothing(port.type, expr.name.place);
    }
    if (value.expr != nullptr) arguments.push_back({{port.name, expr.name.place}, value.expr});
  }
  for (const Setting& setting : expr.settings) {
    if (setting.is_pushed || setting.name.text.empty() || setting.value.kind == Value::Kind::kNone) continue;
    if (historic.ports.contains(setting.name.text) || setting.name.text == "bound_to") continue;
    warn_once("unknown-parameter", expr.name.text + " " + setting.name.text, setting.name.place,
              fmt::format("`{}` has no `{}`; it is left out", text::shown(expr.name.text),
                          text::shown(setting.name.text)));
  }
  return {call(historic.signature->name, expr.name.place, std::move(arguments)), historic.signature->result};
}

TypedDraft Converter::make_list(const Expr& expr, const HistoricSignature& historic, const Port& port,
                                const Level* own) {
  cdl::List list;
  for (const Setting& setting : expr.settings) {
    const auto it = historic.ports.find(setting.name.text);
    if (setting.is_pushed || it == historic.ports.end() || it->second.port != &port) continue;
    const TypedDraft value = make_value(setting, own, port, it->second.unit);
    if (value.expr != nullptr) list.items.push_back(value.expr);
  }
  return {draft(std::move(list), expr.place), port.type};
}

TypedDraft Converter::make_argument(const Expr& expr, const HistoricSignature& historic, const Port& port,
                                    const Level* own) {
  TypedDraft first;
  for (const Setting& setting : expr.settings) {
    const auto it = historic.ports.find(setting.name.text);
    if (setting.is_pushed || it == historic.ports.end() || it->second.port != &port) continue;
    if (setting.value.kind == Value::Kind::kNone) continue;
    if (first.expr != nullptr) {
      sink_.warning("set-twice", setting.name.place,
                    fmt::format("`{}` is set already; this is left out", text::shown(setting.name.text)));
      break;
    }
    first = make_value(setting, own, port, it->second.unit);
  }
  return first;
}

// A class that nothing answers to: what goes into it stays visible.
TypedDraft Converter::make_instance_hole(const Expr& expr, const Level* own, std::string_view wanted) {
  const Definition* declared = definition(expr.name.text);
  std::string type = declared == nullptr ? std::string{} : vocabulary_.type(declared->type.text);
  if (type.empty()) type = wanted.empty() ? "Vector" : std::string(wanted);
  if (declared != nullptr)
    holes_.explain(expr.name.text, "which the file defined: write it as a procedure of CNL or an assemblage");
  std::vector<Holes::HoleArgument> given;
  std::map<std::string, int> times;
  for (const Setting& setting : expr.settings) {
    if (setting.is_pushed || setting.name.text.empty() || setting.value.kind == Value::Kind::kNone) continue;
    Port port;
    if (declared != nullptr) {
      const auto it = std::ranges::find_if(
          declared->params, [&](const ParamDecl& p) { return p.name.text == setting.name.text; });
      if (it != declared->params.end()) port.type = vocabulary_.type(it->type.text);
    }
    std::string name = setting.name.text;
    const int time = ++times[name];
    if (!setting.index.text.empty()) {
      name += fmt::format("_{}", time);
    } else if (time > 1) {
      continue;
    }
    Value value = setting.value;
    const Level* at = own;
    if (value.kind == Value::Kind::kPushedUp) {
      const std::optional<BoundValue> found = look_up(own, value.up, setting.name.text);
      if (!found) continue;
      if (found->joined) {
        given.push_back({name, {*found->joined, value.place}, {}});
        continue;
      }
      value = *found->value;
      at = found->level;
    }
    if (value.kind == Value::Kind::kConstant) {
      given.push_back({name, with_names(value.constant), {}});
    } else if (value.kind == Value::Kind::kExpr && value.expr != nullptr) {
      TypedDraft made = make(*value.expr, at, port.type);
      if (made.expr != nullptr && !made.type.empty()) given.push_back({name, {}, std::move(made)});
    }
  }
  return make_hole(expr.name.text, type, std::move(given), expr.name.place);
}

}  // namespace mlab::cdl_historic
