#include "mlab/cli/describe_configuration.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/cli/describe_historic.h"
#include "mlab/cli/input.h"
#include "mlab/cli/terminal.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

using Json = nlohmann::ordered_json;

// What can be shown of any declaration.
struct Declaration {
  const char* kind = "";
  std::string name;
  std::string type;  // of its value; empty: none said
  std::string help;
  const std::vector<cdl::Parameter>* parameters = nullptr;
  std::vector<std::string> historic_names;
  std::vector<std::string> details;
  text::Place place;
};

Declaration declaration_of(const cdl::Assemblage& assemblage) {
  Declaration out{"assemblage",
                  assemblage.name.text,
                  assemblage.result_type.text,
                  assemblage.help,
                  &assemblage.parameters,
                  {},
                  {},
                  assemblage.name.place};
  for (const cdl::Word& name : assemblage.historic_names) out.historic_names.push_back(name.text);
  return out;
}

Declaration declaration_of(const cdl::Binding& binding) {
  return {"binding point",
          binding.name.text,
          binding.result_type.text.empty() ? "actuator" : binding.result_type.text,
          binding.help,
          &binding.parameters,
          {},
          {},
          binding.name.place};
}

Declaration declaration_of(const cdl::RobotClass& robot_class) {
  Declaration out{"class", robot_class.name.text, "", robot_class.help, &robot_class.parameters, {},
                  {},      robot_class.name.place};
  for (const cdl::BodySetting& setting : robot_class.body)
    out.details.push_back(fmt::format("body {} = {}", setting.name.text, cdl::print(*setting.value)));
  for (const cdl::Device& device : robot_class.devices) {
    out.details.push_back(fmt::format("{} {}: {}, serves {}", device.is_actuator ? "actuator" : "sensor",
                                      device.name.text, device.by.callee.text, device.binds.text));
  }
  return out;
}

Declaration declaration_of(const cdl::Robot& robot) {
  Declaration out{"robot", robot.name.text, robot.class_name.text, robot.help, &robot.parameters, {},
                  {},      robot.name.place};
  for (const cdl::Drive& drive : robot.drives) out.details.push_back("drives " + drive.binding.text);
  return out;
}

Declaration declaration_of(const cdl::Society& society) {
  return {"society", society.name.text, "", society.help, nullptr, {}, {}, society.name.place};
}

template <class Kind>
void add(std::vector<Declaration>& out, const cdl::Configuration::Table<Kind>& table) {
  for (const auto& [name, what] : table) out.push_back(declaration_of(*what));
}

// Those of one file, or of the library.
std::vector<Declaration> declarations_of(const cdl::Configuration& configuration,
                                         const text::SourcePtr& only) {
  std::vector<Declaration> out;
  add(out, configuration.assemblages);
  add(out, configuration.bindings);
  add(out, configuration.classes);
  add(out, configuration.robots);
  add(out, configuration.societies);
  if (only) std::erase_if(out, [&](const Declaration& one) { return one.place.source != only; });
  return out;
}

std::string type_text(const cdl::Parameter& parameter) {
  return parameter.unit.text.empty() ? parameter.type.text
                                     : fmt::format("{} [{}]", parameter.type.text, parameter.unit.text);
}

std::string range_text(const cdl::Parameter& parameter) {
  if (!parameter.low || !parameter.high) return "";
  const auto shown = [](const cdl::Number& number) {
    return number.unit.text.empty() ? fmt::format("{}", number.value)
                                    : fmt::format("{} {}", number.value, number.unit.text);
  };
  return fmt::format("{} .. {}", shown(*parameter.low), shown(*parameter.high));
}

std::string notes_text(const cdl::Parameter& parameter) {
  std::string out = parameter.initial ? "default " + cdl::print(*parameter.initial) : "must be given";
  if (const std::string range = range_text(parameter); !range.empty()) out += ", " + range;
  return out;
}

void print_text(const Declaration& one) {
  fmt::print("{}: {}{}\n", one.name, one.kind, one.type.empty() ? "" : ", " + one.type);
  if (!one.help.empty()) fmt::print("\n  {}\n", one.help);
  if (one.parameters != nullptr && !one.parameters->empty()) {
    fmt::print("\nparameters\n");
    for (const cdl::Parameter& parameter : *one.parameters) {
      fmt::print("  {:<24} {}  ({})\n", parameter.name.text, type_text(parameter), notes_text(parameter));
      if (!parameter.help.empty()) fmt::print("  {:<24}   {}\n", "", parameter.help);
    }
  }
  if (!one.details.empty()) fmt::print("\n");
  for (const std::string& detail : one.details) fmt::print("  {}\n", detail);
  if (!one.historic_names.empty()) fmt::print("\nhistoric names:");
  for (const std::string& name : one.historic_names) fmt::print(" {}", name);
  if (!one.historic_names.empty()) fmt::print("\n");
  print_historic_names(one.name);
  if (one.place.source) {
    fmt::print("\ndeclared in {}:{}\n", one.place.source->name(),
               one.place.source->line_column(one.place.span.begin).line);
  }
}

void print_markdown(const Declaration& one) {
  fmt::print("## {}\n\n{}\n\nKind: {}{}.\n", one.name, one.help, one.kind,
             one.type.empty() ? "" : fmt::format(", {}", one.type));
  if (one.parameters != nullptr && !one.parameters->empty()) {
    fmt::print("\n| parameter | type | default | range | meaning |\n|---|---|---|---|---|\n");
    for (const cdl::Parameter& parameter : *one.parameters) {
      fmt::print("| {} | {} | {} | {} | {} |\n", parameter.name.text, type_text(parameter),
                 parameter.initial ? cdl::print(*parameter.initial) : "", range_text(parameter),
                 parameter.help);
    }
  }
  for (const std::string& detail : one.details) fmt::print("\n- {}", detail);
  fmt::print("\n");
}

Json declaration_json(const Declaration& one) {
  Json out;
  out["kind"] = one.kind;
  out["name"] = one.name;
  out["type"] = one.type.empty() ? Json(nullptr) : Json(one.type);
  out["help"] = one.help;
  out["parameters"] = Json::array();
  if (one.parameters != nullptr) {
    for (const cdl::Parameter& parameter : *one.parameters) {
      out["parameters"].push_back(
          {{"name", parameter.name.text},
           {"type", parameter.type.text},
           {"unit", parameter.unit.text},
           {"default", parameter.initial ? Json(cdl::print(*parameter.initial)) : Json(nullptr)},
           {"range", range_text(parameter)},
           {"help", parameter.help}});
    }
  }
  out["details"] = one.details;
  out["historic_names"] = one.historic_names;
  return out;
}

void show(const std::vector<Declaration>& all, const std::string& format) {
  if (format == "json") {
    Json out = Json::array();
    for (const Declaration& one : all) out.push_back(declaration_json(one));
    fmt::print("{}\n", (all.size() == 1 ? out.front() : Json{{"version", 1}, {"declarations", out}}).dump(2));
    return;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) fmt::print("\n");
    format == "markdown" ? print_markdown(all[i]) : print_text(all[i]);
  }
}

// `travel_to_location` is as good as `TravelToLocation`.
bool same_letters(std::string_view a, std::string_view b) {
  const auto letters = [](std::string_view name) {
    std::string out;
    for (const char c : name) {
      if (c != '_') out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return out;
  };
  return letters(a) == letters(b);
}

bool answers_to(const Declaration& one, const std::string& name) {
  return same_letters(one.name, name) || std::ranges::any_of(one.historic_names, [&](const std::string& old) {
           return same_letters(old, name);
         });
}

}  // namespace

std::string first_sentence(std::string_view help) {
  const std::size_t end = help.find(". ");
  const std::size_t line = help.find('\n');
  return std::string(help.substr(0, std::min(end == std::string_view::npos ? help.size() : end + 1, line)));
}

std::string describe_declaration(const DescribeOptions& options) {
  for (const Declaration& one : declarations_of(robot::library_configuration(), nullptr)) {
    if (!answers_to(one, options.name)) continue;
    show({one}, options.format);
    return one.name;
  }
  return {};
}

void print_historic_names(std::string_view ours) {
  for (const HistoricMeaning& one : historic_names_of(ours))
    fmt::print("\nstood in the historic libraries as {} ({})\n", one.name, one.architectures);
}

int describe_configuration_file(const DescribeOptions& options) {
  text::Diagnostics sink;
  const text::Result<text::SourcePtr> source = read_input(options.name);
  if (!source) {
    sink.report(source.error());
  } else {
    const cdl::Configuration configuration = cdl::load(*source, robot::library_environment(), sink);
    if (!sink.has_errors()) show(declarations_of(configuration, *source), options.format);
  }
  tell(sink);
  return sink.has_errors() ? kBadInput : kDone;
}

void list_declarations() {
  const std::vector<Declaration> all = declarations_of(robot::library_configuration(), nullptr);
  if (!all.empty()) fmt::print("\n");
  for (const Declaration& one : all)
    fmt::print("{:<28} {:<12} {}\n", one.name, one.kind, first_sentence(one.help));
}

std::vector<std::string> declaration_names() {
  std::vector<std::string> out;
  for (const Declaration& one : declarations_of(robot::library_configuration(), nullptr))
    out.push_back(one.name);
  return out;
}

}  // namespace mlab::cli
