#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "mlab/base/counted.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/describe_configuration.h"
#include "mlab/cli/describe_historic.h"
#include "mlab/cli/input.h"
#include "mlab/cli/terminal.h"
#include "mlab/flow/library.h"
#include "mlab/flow/limit.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cdl/types/arithmetic.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

using Json = nlohmann::ordered_json;
using flow::Behavior;

std::string bracketed(std::string_view unit) {
  return unit.empty() ? "" : fmt::format(" [{}]", unit);
}

std::string range_text(const flow::Input& input) {
  if (!flow::is_limit(input.min) && !flow::is_limit(input.max)) return "";
  if (!flow::is_limit(input.min)) return fmt::format("at most {}", input.max);
  if (!flow::is_limit(input.max)) return fmt::format("at least {}", input.min);
  return fmt::format("{} .. {}", input.min, input.max);
}

std::string need_text(const Behavior& b, const flow::Need& need) {
  std::string out(percept::info(need.sensor).label);
  if (need.range_input >= 0)
    out += fmt::format(" within {}", b.inputs[static_cast<std::size_t>(need.range_input)].name);
  else if (need.range > 0.0)
    out += fmt::format(" within {} m", need.range);
  return out;
}

void print_text(const Behavior& b) {
  fmt::print("{}: {}{}\n\n  {}\n", b.name, b.output == nullptr ? "sink" : b.output->name,
             bracketed(b.output_unit), b.help);
  if (!b.inputs.empty()) fmt::print("\ninputs\n");
  for (const flow::Input& input : b.inputs) {
    std::string notes = input.default_text.empty() ? (input.is_list ? "" : "must be linked")
                                                   : fmt::format("default {}", input.default_text);
    if (const std::string range = range_text(input); !range.empty())
      notes += fmt::format("{}{}", notes.empty() ? "" : ", ", range);
    fmt::print("  {:<24} {}{}{}{}\n", input.name, input.is_list ? "list of " : "", input.type->name,
               bracketed(input.unit), notes.empty() ? "" : fmt::format("  ({})", notes));
    if (!input.help.empty()) fmt::print("  {:<24}   {}\n", "", input.help);
  }
  for (const flow::Need& need : b.needs) fmt::print("\nsenses {}\n", need_text(b, need));
  if (b.is_pure) fmt::print("\npure: equal inputs give equal outputs, so calls are shared\n");
  if (b.latency_cycles > 0)
    fmt::print("\nasynchronous: its value comes {} after its inputs\n",
               base::counted(static_cast<std::size_t>(b.latency_cycles), "cycle"));
  if (!b.aliases.empty()) fmt::print("\nhistoric names:");
  for (const flow::Alias& alias : b.aliases) fmt::print(" {}", alias.name);
  if (!b.aliases.empty()) fmt::print("\n");
  print_historic_names(b.name);
  if (!b.source.empty()) fmt::print("\nsource: {}\n", b.source);
  fmt::print("\ndefined in {}\n", b.file);
}

void print_markdown(const Behavior& b) {
  fmt::print("## {}\n\n{}\n\nOutput: {}{}.", b.name, b.help,
             b.output == nullptr ? "none (a sink)" : b.output->name, bracketed(b.output_unit));
  if (!b.aliases.empty()) fmt::print(" Historic names:");
  for (const flow::Alias& alias : b.aliases) fmt::print(" `{}`", alias.name);
  fmt::print("\n");
  if (!b.source.empty()) fmt::print("\nSource: {}\n", b.source);
  if (!b.inputs.empty())
    fmt::print("\n| input | type | default | range | meaning |\n|---|---|---|---|---|\n");
  for (const flow::Input& input : b.inputs) {
    fmt::print("| {} | {}{}{} | {} | {} | {} |\n", input.name, input.is_list ? "list of " : "",
               input.type->name, bracketed(input.unit), input.default_text, range_text(input), input.help);
  }
  fmt::print("\n");
}

Json behavior_json(const Behavior& b) {
  Json out;
  out["name"] = b.name;
  out["help"] = b.help;
  out["source"] = b.source;
  out["file"] = b.file;
  out["output"] =
      b.output == nullptr ? Json(nullptr) : Json{{"type", b.output->name}, {"unit", b.output_unit}};
  out["inputs"] = Json::array();
  for (const flow::Input& input : b.inputs) {
    out["inputs"].push_back(
        {{"name", input.name},
         {"type", input.type->name},
         {"unit", input.unit},
         {"help", input.help},
         {"is_list", input.is_list},
         {"default", input.default_text.empty() ? Json(nullptr) : Json(input.default_text)},
         {"min", flow::is_limit(input.min) ? Json(input.min) : Json(nullptr)},
         {"max", flow::is_limit(input.max) ? Json(input.max) : Json(nullptr)}});
  }
  out["aliases"] = Json::array();
  for (const flow::Alias& alias : b.aliases) out["aliases"].push_back(alias.name);
  out["is_pure"] = b.is_pure;
  out["latency_cycles"] = b.latency_cycles;
  return out;
}

int describe_all(const std::string& format) {
  const std::vector<const Behavior*> all = robot::component_library().behaviors();
  if (format == "json") {
    Json out = Json::array();
    for (const Behavior* b : all) out.push_back(behavior_json(*b));
    fmt::print("{}\n", Json{{"version", 1}, {"components", out}}.dump(2));
    return kDone;
  }
  if (format == "markdown") {
    for (const Behavior* b : all) print_markdown(*b);
    return kDone;
  }
  for (const Behavior* b : all) {
    fmt::print("{:<28} {:<12} {}\n", b->name, b->output == nullptr ? "(sink)" : b->output->name,
               first_sentence(b->help));
  }
  list_declarations();
  fmt::print(
      "\n{} components; `mlab describe NAME` shows one, `mlab describe robot` the parameters of the standard "
      "robot.\n",
      all.size());
  return kDone;
}

int describe_robot(const std::string& format) {
  text::Diagnostics sink;
  const auto standard = robot::load_program("robot", {}, {}, {}, {}, sink);
  if (!standard) {
    tell(sink);
    return kFailed;
  }
  Json parameters = Json::array();
  if (format == "text")
    fmt::print("robot: the standard robot of missions. Parameters that NEW-ROBOT can set:\n\n");
  if (format == "markdown") fmt::print("| parameter | default | meaning |\n|---|---|---|\n");
  for (const flow::Port& port : standard->program->ports()) {
    if (port.role != flow::Port::Role::kParameter) continue;
    const std::string value = flow::Program::print(standard->initial.data(), port);
    if (format == "json") {
      parameters.push_back({{"name", port.path},
                            {"type", port.type->name},
                            {"unit", port.edge_unit},
                            {"default", value},
                            {"help", port.help}});
    } else if (format == "markdown") {
      fmt::print("| {} | {}{} | {} |\n", port.path, value, bracketed(port.edge_unit), port.help);
    } else {
      fmt::print("  {:<38} {:>12}{:<6} {}\n", port.path, value, bracketed(port.edge_unit), port.help);
    }
  }
  if (format == "json")
    fmt::print("{}\n", Json{{"version", 1}, {"robot", "standard"}, {"parameters", parameters}}.dump(2));
  return kDone;
}

// @return the name of what was shown; empty: there is nothing of that name
std::string describe_component(const DescribeOptions& options) {
  const Behavior* behavior = robot::component_library().find(options.name).behavior;
  const cdl::Function* function = behavior == nullptr ? cdl::function_named(options.name) : nullptr;
  if (function != nullptr) {
    behavior = robot::component_library().find(function->behavior).behavior;
    const std::string says = fmt::format("{}({}): in formulas of configurations, {}", function->name,
                                         fmt::join(function->inputs, ", "), function->help);
    if (options.format == "text") fmt::print("{}\n{}", says, behavior == nullptr ? "" : "\ncomputed by ");
    if (behavior == nullptr) return std::string(function->name);
  }
  if (behavior == nullptr) return describe_declaration(options);
  if (options.format == "json")
    fmt::print("{}\n", behavior_json(*behavior).dump(2));
  else if (options.format == "markdown")
    print_markdown(*behavior);
  else
    print_text(*behavior);
  return std::string(behavior->name);
}

void refuse_unknown(const std::string& name) {
  std::vector<std::string> names = robot::component_library().names();
  for (const std::string& declared : declaration_names()) names.push_back(declared);
  std::string nearest = text::nearest_name(name, names);
  if (const Behavior* behavior = robot::component_library().find(nearest).behavior) nearest = behavior->name;
  fmt::print(stderr, "mlab describe: there is no component `{}`{}\n", name,
             nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest));
}

}  // namespace

int describe(const DescribeOptions& options) {
  if (options.name.empty()) return describe_all(options.format);
  if (options.name == "robot" || options.name == "standard") return describe_robot(options.format);
  if (is_standard_input(options.name) || robot::names_configuration(options.name))
    return describe_configuration_file(options);
  const std::vector<HistoricMeaning> meanings = historic_meanings(options.name);
  std::string shown = describe_component(options);
  const bool is_known = !shown.empty();
  for (const HistoricMeaning& one : meanings) {
    if (one.ours == shown) continue;
    if (!is_known) {
      shown = describe_component({one.ours, options.format});
    } else if (options.format == "text") {
      fmt::print("\nin the historic libraries ({}), `{}` was what is `{}` here\n", one.architectures,
                 one.name, one.ours);
    }
  }
  if (!shown.empty()) return kDone;
  refuse_unknown(options.name);
  return kBadInput;
}

}  // namespace mlab::cli
