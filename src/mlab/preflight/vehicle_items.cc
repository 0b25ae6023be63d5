#include "mlab/preflight/vehicle_items.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/base/angle.h"
#include "mlab/base/counted.h"
#include "mlab/fleet/fence.h"

namespace mlab::preflight {
namespace {

using enum vehicle::CheckResult;

// Where what is measured passes, and where it fails; between the two somebody should know.
constexpr double kGoodRoundTrip = 0.15;  // [s]; a vehicle stands where commands are older than 0.5 s
constexpr double kBadRoundTrip = 0.4;
constexpr double kGoodLoss = 0.1;
constexpr double kBadLoss = 0.3;
constexpr double kGoodReportAge = 0.3;  // [s]; a vehicle says twenty times a second how it is
constexpr double kBadReportAge = 1.0;
constexpr double kGoodClock = 1.0;    // [s]
constexpr double kGoodBattery = 0.3;  // share that is left
constexpr double kBadBattery = 0.15;
constexpr double kGoodStandstill = 3.0;  // [s]
constexpr double kNearStart = 0.5;       // [m]; the log tells of more
constexpr double kFarFromStart = 5.0;    // [m]; then map and vehicle hardly mean the same place
constexpr double kSpeedRounding = 1e-6;

/// Of numbers that are better the smaller they are.
CheckResult graded(double value, double good, double bad) {
  return value <= good ? kPass : value <= bad ? kWarn : kFail;
}

std::string place_words(geom::Point place) {
  return fmt::format("({:.1f}, {:.1f}) m", place.x, place.y);
}

std::string drive_words(binding::Drive drive) {
  constexpr std::string_view kWords[] = {"holonomic", "differential drive", "steered as a car",
                                         "synchro drive"};
  return std::string(kWords[static_cast<std::size_t>(drive)]);
}

/// `parameter FS_ACTION`: `parameter-fs_action`.
std::string slug_of(std::string_view name) {
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    out += std::isalnum(byte) != 0 || c == '_' ? static_cast<char>(std::tolower(byte)) : '-';
  }
  return out;
}

class Items {
 public:
  Items(const VehicleFacts& vehicle, const Wants& wants, const std::string& version)
      : vehicle_(vehicle), wants_(wants), version_(version) {}

  std::vector<Item> take() {
    add_presence();
    if (!vehicle_.is_there) return std::move(out_);
    add_limits();
    add_link();
    add_reports();
    if (vehicle_.report) {
      add_state();
      add_place();
      add_fences();
      add_sensors();
    }
    add_battery();
    add_speed();
    add_own_checks();
    return std::move(out_);
  }

 private:
  void add(std::string_view name, CheckResult result, std::string is, std::string expected = "") {
    out_.push_back({fmt::format("{}/{}", vehicle_.name, slug_of(name)), vehicle_.name, std::string(name),
                    result, std::move(is), std::move(expected)});
  }

  void add_presence() {
    if (!vehicle_.is_there) {
      add("presence", kFail, vehicle_.why_not_there, "takes part in the fleet");
      return;
    }
    add("presence", kPass,
        fmt::format("{}, on {}", vehicle_.kind,
                    vehicle_.machine.empty() ? "a machine without a name" : vehicle_.machine));
    add("version", vehicle_.version == version_ ? kPass : kWarn, "missionlab " + vehicle_.version,
        fmt::format("{}, as here", version_));
    if (wants_.robots.size() > 1)
      add("robots", kFail, fmt::format("is the body of robots {}", fmt::join(wants_.robots, ", ")),
          "the body of one robot: the others can't start");
  }

  void add_limits() {
    if (!vehicle_.limits) {
      add("limits", kFail, "says limits that can't be: " + vehicle_.limits_refusal, "says what it can do");
      return;
    }
    const vehicle::Limits& limits = *vehicle_.limits;
    const double fastest = limits.kinematics.max_speed;
    add("limits", fastest > 0.0 ? kPass : kWarn,
        fmt::format("{}, radius {:.2g} m, {}, {}", drive_words(limits.kinematics.drive), limits.radius,
                    fastest > 0.0 ? fmt::format("at most {:.2g} m/s", fastest) : "no limit to its speed",
                    limits.min_speed < 0.0 ? "also backwards" : "never backwards"),
        fastest > 0.0 ? "" : "a greatest speed: start its process with --max-speed");
    add("standstill", limits.standstill <= kGoodStandstill ? kPass : kWarn,
        fmt::format("stands {:.1f} s after the last command, as it states", limits.standstill),
        fmt::format("at most {:.2g} s", kGoodStandstill));
  }

  void add_link() {
    constexpr std::string_view kExpected = "150 ms there and back, 10 % lost at the most";
    if (!vehicle_.link) {
      add("link", kFail, "has answered no question", std::string(kExpected));
      add("clock", kUnknown, "has answered no question");
      return;
    }
    const Link& link = *vehicle_.link;
    add("link",
        std::max(graded(link.round_trip, kGoodRoundTrip, kBadRoundTrip),
                 graded(link.lost, kGoodLoss, kBadLoss)),
        fmt::format("{:.1f} ms there and back, {}", link.round_trip * 1000.0,
                    link.lost > 0.0 ? fmt::format("{:.0f} % lost", link.lost * 100.0) : "nothing lost"),
        std::string(kExpected));
    const double offset = link.clock_offset;
    add("clock", std::abs(offset) <= kGoodClock ? kPass : kWarn,
        std::abs(offset) <= link.round_trip / 2.0
            ? "shows the same time as here"
            : fmt::format("is {:.3g} s {} this machine's", std::abs(offset),
                          offset > 0.0 ? "ahead of" : "behind"),
        "within a second: else times in its log are not those of the run's");
  }

  void add_reports() {
    if (!vehicle_.report) {
      add("reports", kFail, "has said nothing that can be read", "says twenty times a second how it is");
      return;
    }
    add("reports", graded(vehicle_.report_age, kGoodReportAge, kBadReportAge),
        fmt::format("the newest is {:.1f} s old", vehicle_.report_age),
        "not older than 0.3 s: it says twenty times a second how it is");
  }

  void add_state() {
    using vehicle::Readiness;
    const vehicle::Report& report = *vehicle_.report;
    const std::string why = report.why.empty() ? "" : ": it " + report.why;
    switch (report.readiness) {
      case Readiness::kReady:
        add("state", kPass, "is ready");
        break;
      case Readiness::kStandby:
        add("state", kPass, "gets ready when it is driven" + why);
        break;
      case Readiness::kTaken:
        add("state", kWarn, "somebody else has it" + why, "nobody has it: it is left to who has it");
        break;
      case Readiness::kNotReady:
        add("state", kFail, "would not move" + why, "is ready");
        break;
      case Readiness::kAbsent:
        add("state", kFail, "its device is not there" + why, "is ready");
        break;
      case Readiness::kSilent:
        add("state", kFail, "its device says nothing" + why, "is ready");
        break;
      case Readiness::kFaulty:
        add("state", kFail, "is faulty" + why, "is ready");
        break;
    }
    if (vehicle_.is_driven) add("driver", kFail, "another run drives it", "nobody does");
    if (vehicle_.is_stopped)
      add("emergency stop", kWarn, "holds", "released: until then it stands, whatever a mission says");
  }

  // Where it will be when the mission starts it; nothing: nobody knows.
  std::optional<geom::Point> beginning() const {
    const vehicle::Report& report = *vehicle_.report;
    if (!report.is_global) return wants_.start ? std::optional(wants_.start->position) : std::nullopt;
    return report.motion ? std::optional(report.motion->pose.position) : std::nullopt;
  }

  void add_place() {
    const vehicle::Report& report = *vehicle_.report;
    if (!report.motion) {
      add("place", kFail, "does not say where it is", "says it: else its robot does not start");
      return;
    }
    if (!wants_.start) {
      add("place", kWarn, "no START of the mission names its robot", "is started by the mission");
      return;
    }
    const geom::Pose& start = *wants_.start;
    if (!report.is_global) {
      add("place", kUnknown, "counts its way from where it begins, and does not know the map",
          fmt::format("stands at {}, looking to {:.0f} degrees", place_words(start.position),
                      base::degrees(start.heading)));
      return;
    }
    const geom::Point is = report.motion->pose.position;
    const double away = geom::distance(is, start.position);
    add("place", graded(away, kNearStart, kFarFromStart),
        fmt::format("is at {}, {:.1f} m from its START", place_words(is), away),
        fmt::format("within {} m of {}", kNearStart, place_words(start.position)));
  }

  void add_fences() {
    bool has_fence = false;
    for (const mission::Failsafe* row : wants_.rows) {
      if (row->condition != mission::FailsafeCondition::kOutside || row->fence.size() < 3) continue;
      has_fence = true;
      const std::string name = "geofence " + row->fence_name;
      const auto place = beginning();
      if (!place) {
        add(name, kUnknown, "does not say where it is", "inside");
        continue;
      }
      const double depth = fleet::Fence(row->fence).depth(*place);
      const double radius = vehicle_.limits ? vehicle_.limits->radius : 0.0;
      add(name,
          depth >= radius ? kPass
          : depth > 0.0   ? kWarn
                          : kFail,
          fmt::format("{} m {} its line{}", fmt::format("{:.1f}", std::abs(depth)),
                      depth > 0.0 ? "inside of" : "outside of",
                      vehicle_.report->is_global ? "" : ", where START puts it"),
          "inside, with all of its body");
    }
    if (!has_fence)
      add("geofence", kWarn, "the mission keeps it within nothing",
          "a row as `FAILSAFE OUTSIDE Field RETURN`");
  }

  void add_sensors() {
    const vehicle::Report& report = *vehicle_.report;
    if (report.scans.empty()) {
      add("sensors", kWarn, "tells nothing of distances: it drives around nothing but what the map shows",
          "a sensor of distances");
      return;
    }
    for (const vehicle::Scan& scan : report.scans) {
      const double age = vehicle::seconds_between(scan.at, vehicle_.arrived) + vehicle_.report_age;
      const auto told = std::ranges::count_if(scan.distances, [](float one) { return !std::isnan(one); });
      const bool is_whole = static_cast<std::size_t>(told) * 2 >= scan.distances.size() && told > 0;
      add(report.scans.size() == 1 ? "sensors" : fmt::format("sensor {}", scan.sensor),
          std::max(graded(age, kBadReportAge, 2.0 * kBadReportAge), is_whole ? kPass : kWarn),
          fmt::format("{} of {} tell something, up to {:.1f} m, {:.1f} s old", told,
                      base::counted(scan.distances.size(), "beam"), scan.farthest, age),
          "at least half of them, not older than 1 s");
    }
  }

  void add_battery() {
    const bool is_told = vehicle_.report && vehicle_.report->battery;
    if (!is_told) {
      add("battery", kUnknown, "does not say how much is left");
      return;
    }
    const vehicle::Battery& battery = *vehicle_.report->battery;
    add("battery",
        battery.share >= kGoodBattery  ? kPass
        : battery.share >= kBadBattery ? kWarn
                                       : kFail,
        fmt::format("{:.0f} % left{}", battery.share * 100.0,
                    battery.voltage > 0.0 ? fmt::format(", {:.1f} V", battery.voltage) : ""),
        "at least 30 %");
  }

  void add_speed() {
    const double most = vehicle_.limits ? vehicle_.limits->kinematics.max_speed : 0.0;
    if (most <= 0.0 || wants_.speed <= 0.0) return;
    add("speed", wants_.speed <= most + kSpeedRounding ? kPass : kWarn,
        fmt::format("the mission asks for up to {:.2g} m/s", wants_.speed),
        fmt::format("{:.2g} m/s at the most: it goes no faster, and stays behind others that do", most));
  }

  void add_own_checks() {
    if (!vehicle_.checks || vehicle_.checks->empty()) {
      add("its own checks", kUnknown,
          vehicle_.checks ? "tells none: its own failsafes are not known" : "has not told any");
      return;
    }
    std::set<std::string> ids;
    for (const vehicle::Check& one : *vehicle_.checks) {
      const std::string plain = fmt::format("{}/own/{}", vehicle_.name, slug_of(one.name));
      std::string id = plain;
      for (int i = 2; !ids.insert(id).second; ++i) id = fmt::format("{}-{}", plain, i);
      out_.push_back({std::move(id), vehicle_.name, one.name, one.result, one.is, one.expected});
    }
  }

  const VehicleFacts& vehicle_;
  const Wants& wants_;
  const std::string& version_;
  std::vector<Item> out_;
};

}  // namespace

std::vector<Item> items_of(const VehicleFacts& vehicle, const Wants& wants, const std::string& version) {
  return Items(vehicle, wants, version).take();
}

}  // namespace mlab::preflight
