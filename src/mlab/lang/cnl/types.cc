#include "mlab/lang/cnl/types.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mlab::cnl {
namespace {

constexpr std::array kTypes = {
    PortType{"bool", "bool", false, true},
    PortType{"int", "int", false, true},
    PortType{"double", "double", false, true},
    PortType{"Vector", "Vector"},
    PortType{"Point", "Point"},
    PortType{"Pose", "Pose"},
    PortType{"Obstacles", "Obstacles", true},
    PortType{"Robots", "Robots", true},
    PortType{"Objects", "Objects", true},
    PortType{"Object", "ObjectReading"},
    PortType{"Ranges", "Ranges", true},
    PortType{"ObjectClasses", "ObjectClasses"},
    PortType{"Formation", "Formation", false, true},
    PortType{"FormationReference", "FormationReference", false, true},
    PortType{"Task", "Task", false, true},
    PortType{"Text", "Text"},
};

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kHistoric = {{
    {"boolean", "bool"},
    {"float", "double"},
    {"short", "int"},
    {"long", "int"},
    {"char", "int"},
    {"signed", "int"},
    {"unsigned", "int"},
    {"robot_position", "Pose"},
    {"obs_array", "Obstacles"},
    {"ObjectList", "Objects"},
    {"ObjectReading", "Object"},
    {"OneObjectClass", "ObjectClasses"},
    {"CNLString_t", "Text"},
    {"gt_Formation", "Formation"},
}};

constexpr std::array<std::string_view, 6> kLost = {"type_pry",        "Reinforcer", "gt_Unit_Members",
                                                   "raw_sonar_array", "gt_Command", "vector_array"};

}  // namespace

const PortType* find_port_type(std::string_view name) {
  const auto* const historic = std::ranges::find(kHistoric, name, [](const auto& h) { return h.first; });
  if (historic != kHistoric.end()) name = historic->second;
  const auto* const found = std::ranges::find(kTypes, name, &PortType::name);
  return found == kTypes.end() ? nullptr : found;
}

std::vector<std::string> port_type_names() {
  std::vector<std::string> out;
  for (const PortType& type : kTypes) out.emplace_back(type.name);
  for (const auto& [name, meaning] : kHistoric) out.emplace_back(name);
  return out;
}

bool is_lost_historic_type(std::string_view name) {
  return std::ranges::find(kLost, name) != kLost.end();
}

}  // namespace mlab::cnl
