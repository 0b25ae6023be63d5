#include "mlab/recording/action_difference.h"

#include <cmath>

#include <fmt/core.h>

namespace mlab::recording {
namespace {

std::string velocity_of(const wire::Action& action) {
  return action.drives() ? fmt::format("({}, {}) m/s", action.velocity_x(), action.velocity_y()) : "to stand";
}
std::string spin_of(const wire::Action& action) {
  return action.spins() ? fmt::format("to turn at {} rad/s", action.spin()) : "no turn";
}
std::string pan_of(const wire::Action& action) {
  return action.looks() ? fmt::format("to look to {} rad", action.pan()) : "to look as it does";
}
std::string status_of(const wire::Action& action) {
  const double remaining = action.status().remaining();
  const std::string rest = std::isinf(remaining) ? "no way farther"
                           : remaining < 0.0     ? fmt::format("{} steps on", -remaining)
                                                 : fmt::format("{} m to go", remaining);
  return fmt::format("{}, {} with order {}", action.status().done() ? "done" : "not done", rest,
                     action.status().sequence());
}
std::string requests_of(const wire::Action& action) {
  std::string out;
  for (const wire::Request& request : action.requests())
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", wire::Request::Kind_Name(request.kind()),
                       request.object());
  return out.empty() ? "nothing" : out;
}

}  // namespace

std::string difference(const wire::Action& is, const wire::Action& was) {
  if (is.SerializeAsString() == was.SerializeAsString()) return "";
  struct Part {
    const char* verb;
    std::string (*text)(const wire::Action&);
  };
  constexpr Part kParts[] = {{"wants", velocity_of},
                             {"wants", spin_of},
                             {"wants", pan_of},
                             {"says that it is", status_of},
                             {"asks for", requests_of}};
  for (const Part& part : kParts) {
    const std::string now = part.text(is);
    const std::string then = part.text(was);
    if (now != then) return fmt::format("{} {}; recorded is {}", part.verb, now, then);
  }
  return "does something else than what was recorded";
}

}  // namespace mlab::recording
