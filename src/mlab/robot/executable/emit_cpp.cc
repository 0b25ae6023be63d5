#include "mlab/robot/executable/emit_cpp.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/lang/cnl/cpp_writer.h"
#include "mlab/lang/cnl/declarations.h"
#include "mlab/lang/cnl/generate.h"
#include "mlab/lang/cnl/native_module.h"

namespace mlab::robot_build {
namespace {

using cnl::cpp_string;

// More files than this cost more to start the compiler for than they spare.
constexpr std::size_t kMostGroups = 32;
// A compiler likes functions of a bounded length.
constexpr std::size_t kMostNodes = 300;

// What stands before the last dot of a node's name, at most so many words of it.
std::string_view part_of(std::string_view name, std::size_t words) {
  const std::size_t last = name.rfind('.');
  if (last == std::string_view::npos || words == 0) return {};
  std::size_t end = 0;
  for (std::size_t n = 0; n < words && end < last; ++n) end = std::min(name.find('.', end + (n > 0)), last);
  return name.substr(0, end);
}

// The finest cut into parts that are not too many.
std::size_t words_of_parts(const flow::Network& network) {
  std::size_t best = 0;
  for (std::size_t words = 1; words <= 64; ++words) {
    std::set<std::string_view> parts;
    for (const flow::Node& node : network.nodes) parts.insert(part_of(node.name, words));
    if (parts.size() > kMostGroups) break;
    best = words;
  }
  return best;
}

struct Group {
  std::string part;  // `movement.Searching`; empty: the top
  std::string name;  // a word of C++
  std::vector<const flow::Node*> nodes;
};

struct Grouping {
  std::vector<Group> groups;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // group and count, in the order of the nodes
};

std::string word_of(std::string_view part) {
  std::string out(part.empty() ? "top" : part);
  for (char& c : out) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return out;
}

std::string fresh_name(const std::string& part, std::size_t piece, std::set<std::string>& taken) {
  std::string name = word_of(part);
  if (piece > 0) name += fmt::format("_{}", piece + 1);
  if (!taken.insert(name).second) {
    name += fmt::format("_{:08x}", base::hash_text(part) >> 32);
    taken.insert(name);
  }
  return name;
}

Grouping group(const flow::Network& network) {
  Grouping out;
  const std::size_t words = words_of_parts(network);
  struct Open {
    std::size_t group = 0;
    std::size_t pieces = 0;
  };
  std::map<std::string, Open, std::less<>> open;
  std::set<std::string> taken;
  for (const flow::Node& node : network.nodes) {
    const std::string part(part_of(node.name, words));
    Open& at = open[part];
    if (at.pieces == 0 || out.groups[at.group].nodes.size() >= kMostNodes) {
      at.group = out.groups.size();
      out.groups.push_back({part, fresh_name(part, at.pieces++, taken), {}});
    }
    out.groups[at.group].nodes.push_back(&node);
    if (!out.order.empty() && out.order.back().first == at.group)
      ++out.order.back().second;
    else
      out.order.emplace_back(at.group, 1);
  }
  return out;
}

std::string value(const flow::Source& source) {
  return fmt::format("{}({})", source.kind == flow::Source::Kind::kConstant ? "constant" : "from",
                     cpp_string(source.text));
}

std::string_view kind_word(flow::Node::Kind kind) {
  switch (kind) {
    case flow::Node::Kind::kSequence:
      return "sequence";
    case flow::Node::Kind::kSelect:
      return "select";
    case flow::Node::Kind::kDelay:
      return "delay";
    default:
      return "behavior";
  }
}

void write_states(const flow::Node& node, std::string& out) {
  for (const flow::State& state : node.states) {
    out += fmt::format("\n      .state({}, {})", cpp_string(state.name), value(state.member));
    if (state.is_start) out += ".start()";
    if (state.is_final) out += ".final()";
    for (const flow::Transition& transition : state.transitions) {
      out += fmt::format("\n          .{}({}, {})", transition.is_negated ? "when_not" : "when",
                         value(transition.trigger), cpp_string(transition.target));
      if (transition.restarts) out += ".restarting()";
    }
  }
}

void write_node(const flow::Node& node, std::string& out) {
  out +=
      fmt::format("  w.{}({}, {})", kind_word(node.kind), cpp_string(node.name), cpp_string(node.behavior));
  for (const flow::Link& link : node.links)
    out += fmt::format("\n      .input({}, {})", cpp_string(link.input), value(link.source));
  write_states(node, out);
  if (node.kind == flow::Node::Kind::kSelect) out += fmt::format("\n      .by({})", value(node.selector));
  for (const flow::Case& one : node.cases) {
    if (one.values.empty()) {
      out += fmt::format("\n      .otherwise({})", value(one.member));
      continue;
    }
    std::string values;
    for (const std::int64_t v : one.values) values += fmt::format("{}{}", values.empty() ? "" : ", ", v);
    out += fmt::format("\n      .on({{{}}}, {})", values, value(one.member));
  }
  if (node.is_public) out += "\n      .watched()";
  out += ";\n";
}

CppFile group_file(const RobotSource& robot, const Group& group) {
  CppFile out;
  out.name = "nodes_" + group.name;
  out.text = fmt::format(
      "// The nodes {} of the robot program {}. Made by mlab build; changes belong into {}.\n"
      "#include \"mlab/robot/process/wiring.h\"\n\n"
      "namespace robot_program {{\n\nusing namespace mlab::robot_process;\n\n"
      "void add_{}(Wiring& w);\n\nvoid add_{}(Wiring& w) {{\n",
      group.part.empty() ? "at the top" : "of " + group.part, robot.name, robot.origin, group.name,
      group.name);
  for (const flow::Node* node : group.nodes) write_node(*node, out.text);
  out.text += "}\n\n}  // namespace robot_program\n";
  return out;
}

void write_parameter(const flow::Parameter& parameter, std::string& out) {
  std::string other_names;
  for (const std::string& name : parameter.other_names)
    other_names += fmt::format("{}{}", other_names.empty() ? "" : ", ", cpp_string(name));
  out += fmt::format("  w.parameter({}, {}, {}, {}, {{{}, {}}},\n              {}, {{{}}});\n",
                     cpp_string(parameter.name), cpp_string(parameter.type), cpp_string(parameter.unit),
                     value(parameter.initial), parameter.min, parameter.max, cpp_string(parameter.help),
                     other_names);
  if (!parameter.place_name.text.empty())
    out += fmt::format("  w.place_name({});\n", cpp_string(parameter.place_name.text));
}

// What main says of the procedures that are brought.
struct Brought {
  std::string functions;  // declared
  std::string names;      // of these
  std::string declarations;
};

Brought brought_by(const RobotSource& robot) {
  Brought out;
  for (const auto& tree : robot.procedures) {
    if (!cnl::has_procedures(*tree)) continue;
    const std::string function = "mlab_cnl_" + cnl::stem_of(tree->source->name());
    out.functions += fmt::format("std::span<const mlab::flow::Behavior* const> {}();\n", function);
    out.names += fmt::format("{}{}", out.names.empty() ? "" : ", ", function);
    if (robot.is_closed) continue;
    for (const cnl::Declarations& one : cnl::declarations_of(*tree))
      out.declarations += fmt::format("{}{{{}, {}}}", out.declarations.empty() ? "" : ", ",
                                      cpp_string(one.file), cpp_string(one.text));
  }
  return out;
}

std::string source_name(const CppFile& file) {
  return "robot_source_" + file.name;
}

// Each file knows what it was made from, so that a change of one is a change of no other.
void add_source(CppFile& file) {
  const std::string_view made_from = file.procedures ? file.procedures->source->text() : file.text;
  file.text += fmt::format("\nextern const std::uint64_t {0};\nconst std::uint64_t {0} = 0x{1:016x};\n",
                           source_name(file), base::hash_text(made_from));
}

CppFile main_file(const RobotSource& robot, const Grouping& grouping, const std::vector<CppFile>& others) {
  CppFile out;
  out.name = "main";
  std::string& text = out.text;
  text = fmt::format(
      "// The robot program {}. Made by mlab build; changes belong into {}.\n"
      "#include \"mlab/robot/process/robot_main.h\"\n\n"
      "std::span<const mlab::flow::Behavior* const> mlab_library_behaviors();\n",
      robot.name, robot.origin);
  const Brought brought = brought_by(robot);
  text += brought.functions;
  for (const CppFile& file : others)
    text += fmt::format("extern const std::uint64_t {};\n", source_name(file));
  text += "\nnamespace robot_program {\n\nusing namespace mlab::robot_process;\n\n";
  std::string functions;
  for (const Group& group : grouping.groups) {
    text += fmt::format("void add_{}(Wiring& w);\n", group.name);
    functions += fmt::format("{}add_{}", functions.empty() ? "" : ",\n                ", group.name);
  }
  std::string order;
  for (const auto& [group, count] : grouping.order)
    order += fmt::format("{}{{{}, {}}}", order.empty() ? "" : ", ", group, count);
  std::string body;
  for (const auto& [name, number] : robot.body)
    body += fmt::format("{}{{{}, {}}}", body.empty() ? "" : ", ", cpp_string(name), number);
  text += fmt::format("\nstatic void add_parameters({}) {{\n",
                      robot.network.parameters.empty() ? "Wiring&" : "Wiring& w");
  for (const flow::Parameter& parameter : robot.network.parameters) write_parameter(parameter, text);
  text += fmt::format(
      "}}\n\n}}  // namespace robot_program\n\n"
      "int main(int argc, char** argv) {{\n  using namespace robot_program;\n"
      "  return robot_main(\n      argc, argv,\n"
      "      {{\n"
      "          .name = {},\n          .version = {},\n          .parameters = add_parameters,\n"
      "          .groups = {{{}}},\n          .order = {{{}}},\n"
      "          .components = mlab_library_behaviors,\n          .brought = {{{}}},\n"
      "          .declarations = {{{}}},\n          .is_closed = {},\n"
      "          .body = {{{}}},\n",
      cpp_string(robot.name), cpp_string(robot.version), functions, order, brought.names,
      brought.declarations, robot.is_closed, body);
  std::string sources = fmt::format("0x{:016x}", base::hash_text(text));
  for (const CppFile& file : others) sources += ", " + source_name(file);
  text += fmt::format("          .sources = {{{}}},\n          .agent = {},\n      }});\n}}\n", sources,
                      cpp_string(robot.agent));
  return out;
}

}  // namespace

std::vector<CppFile> emit_cpp(const RobotSource& robot) {
  const Grouping grouping = group(robot.network);
  std::vector<CppFile> out;
  for (const auto& tree : robot.procedures) {
    if (!cnl::has_procedures(*tree)) continue;
    const std::string stem = cnl::stem_of(tree->source->name());
    out.push_back({"procedures_" + stem, cnl::generate(*tree, {stem + ".cnl.cc", false}), tree});
  }
  for (const Group& one : grouping.groups) out.push_back(group_file(robot, one));
  for (CppFile& file : out) add_source(file);
  out.insert(out.begin(), main_file(robot, grouping, out));
  return out;
}

std::string joined(const std::vector<CppFile>& files) {
  std::string out;
  for (const CppFile& file : files)
    out += fmt::format("{}// ---- {}.cc\n{}", out.empty() ? "" : "\n", file.name, file.text);
  return out;
}

}  // namespace mlab::robot_build
