#pragma once

#include <chrono>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "mlab/agents/roster.h"
#include "mlab/vehicle/line.h"

namespace mlab::vehicles {

inline std::string reports_topic(std::string_view vehicle) {
  return "vehicles/" + std::string(vehicle) + "/reports";
}
inline std::string checks_topic(std::string_view vehicle) {
  return "vehicles/" + std::string(vehicle) + "/checks";
}
inline std::string commands_topic(std::string_view vehicle) {
  return "vehicles/" + std::string(vehicle) + "/commands";
}

/// What is done once where it takes long to wait for something.
struct Wondering {
  std::chrono::milliseconds after;
  std::function<void()> tell;
};

/// Over DDS, to the member of a fleet that is a vehicle of that name.
/// @param patience  so long it is waited for, at most, until the vehicle has said where it is
/// @errors  a sentence
std::expected<std::unique_ptr<vehicle::Line>, std::string> open_line(
    const std::shared_ptr<agents::Roster>& roster, const std::string& name,
    std::chrono::milliseconds patience, const Wondering& wondering);

}  // namespace mlab::vehicles
