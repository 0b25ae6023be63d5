#include "mlab/tables/sensor_tables.h"

#include <fmt/core.h>

#include "mlab/percept/sensors.h"

namespace mlab::tables {

std::string sensor_documentation() {
  std::string out = "| sensor | what it tells |\n|---|---|\n";
  for (const percept::SensorInfo& one : percept::kSensors) {
    out +=
        fmt::format("| `{}`{} | {} |\n", one.name, one.has_own_reach ? "" : " `within` a range", one.tells);
  }
  return out;
}

std::string sensor_words() {
  std::string out;
  for (const percept::SensorInfo& one : percept::kSensors)
    out += fmt::format("{}{}", out.empty() ? "" : "|", one.name);
  return out;
}

std::string sensor_dictionary() {
  std::string out;
  for (const percept::SensorInfo& one : percept::kSensors) out += fmt::format("\"{}\"\n", one.name);
  return out;
}

}  // namespace mlab::tables
