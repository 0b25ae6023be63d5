#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "mlab/preflight/preflight.h"

namespace mlab::preflight {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr std::size_t kMostBytes = 4UL << 20;
constexpr std::array<std::string_view, 4> kResults = {"pass", "warn", "fail", "unknown"};

Json json_of(const CheckedVehicle& one) {
  return {{"name", one.name},
          {"kind", one.kind},
          {"session", one.session},
          {"version", one.version},
          {"simulated", one.is_simulated},
          {"robots", one.robots}};
}

Json json_of(const Item& one) {
  return {{"id", one.id},     {"vehicle", one.vehicle.empty() ? Json(nullptr) : Json(one.vehicle)},
          {"name", one.name}, {"result", kResults[static_cast<std::size_t>(one.result)]},
          {"is", one.is},     {"expected", one.expected}};
}

Json json_of(const ManualItem& one) {
  return {{"id", one.id}, {"text", one.text}};
}

Json json_of(const Acceptance& one) {
  return {{"item", one.item}, {"because", one.because}};
}

template <class T>
Json list_of(const std::vector<T>& all) {
  Json out = Json::array();
  for (const T& one : all) out.push_back(json_of(one));
  return out;
}

Json object_of(const Checklist& checklist) {
  return {{"format", kFormat},
          {"mission", checklist.mission},
          {"fleet", checklist.fleet},
          {"digest", checklist.digest},
          {"needed", checklist.is_needed()},
          {"vehicles", list_of(checklist.vehicles)},
          {"items", list_of(checklist.items)},
          {"manual", list_of(checklist.manual)}};
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Reads what it expects, and knows whether all was there.
class Reading {
 public:
  bool is_whole() const { return is_whole_; }

  std::string text(const Json& from, const char* key) {
    const Json& value = at(from, key);
    return need(value.is_string()) ? value.get<std::string>() : "";
  }
  bool flag(const Json& from, const char* key) {
    const Json& value = at(from, key);
    return need(value.is_boolean()) && value.get<bool>();
  }
  double number(const Json& from, const char* key) {
    const Json& value = at(from, key);
    const double out = need(value.is_number()) ? value.get<double>() : 0.0;
    return need(std::isfinite(out)) ? out : 0.0;
  }
  template <class T, class Read>
  std::vector<T> list(const Json& from, const char* key, Read read) {
    std::vector<T> out;
    const Json& value = at(from, key);
    if (!need(value.is_array())) return out;
    for (const Json& one : value) out.push_back(read(one));
    return out;
  }

  Item item(const Json& from) {
    Item out;
    out.id = text(from, "id");
    const Json& vehicle = at(from, "vehicle");
    if (need(vehicle.is_string() || vehicle.is_null()) && vehicle.is_string())
      out.vehicle = vehicle.get<std::string>();
    out.name = text(from, "name");
    const auto result = std::ranges::find(kResults, text(from, "result"));
    if (need(result != kResults.end())) out.result = static_cast<CheckResult>(result - kResults.begin());
    out.is = text(from, "is");
    out.expected = text(from, "expected");
    return out;
  }
  CheckedVehicle vehicle(const Json& from) {
    CheckedVehicle out{text(from, "name"),    text(from, "kind"),      text(from, "session"),
                       text(from, "version"), flag(from, "simulated"), {}};
    out.robots = list<std::uint32_t>(from, "robots", [&](const Json& one) {
      return need(one.is_number_unsigned()) ? one.get<std::uint32_t>() : 0U;
    });
    return out;
  }
  Checklist checklist(const Json& from) {
    Checklist out;
    need(at(from, "format") == Json(kFormat));
    out.mission = text(from, "mission");
    out.fleet = text(from, "fleet");
    out.digest = text(from, "digest");
    out.vehicles = list<CheckedVehicle>(from, "vehicles", [&](const Json& one) { return vehicle(one); });
    out.items = list<Item>(from, "items", [&](const Json& one) { return item(one); });
    out.manual = list<ManualItem>(
        from, "manual", [&](const Json& one) { return ManualItem{text(one, "id"), text(one, "text")}; });
    return out;
  }
  Signature signature(const Json& from) {
    Signature out;
    out.by = text(from, "by");
    out.at = number(from, "at");
    out.confirmed = list<std::string>(from, "confirmed", [&](const Json& one) {
      return need(one.is_string()) ? one.get<std::string>() : "";
    });
    out.accepted = list<Acceptance>(from, "accepted", [&](const Json& one) {
      return Acceptance{text(one, "item"), text(one, "because")};
    });
    return out;
  }

  /// Null where there is none.
  const Json& at(const Json& from, const char* key) {
    static const Json kNothing;
    if (!from.is_object()) {
      need(false);
      return kNothing;
    }
    const auto found = from.find(key);
    return found == from.end() ? kNothing : *found;
  }

 private:
  bool need(bool holds) {
    is_whole_ = is_whole_ && holds;
    return holds;
  }
  bool is_whole_ = true;
};

}  // namespace

std::string json_of(const Checklist& checklist) {
  return text_of(object_of(checklist));
}

std::string json_of(const SignedChecklist& checklist) {
  const Signature& signature = checklist.signature;
  Json out = object_of(checklist.checklist);
  out["signature"] = {{"by", signature.by},
                      {"at", signature.at},
                      {"confirmed", signature.confirmed},
                      {"accepted", list_of(signature.accepted)}};
  return text_of(out);
}

std::optional<SignedChecklist> read_signed(std::string_view json) {
  if (json.size() > kMostBytes) return std::nullopt;
  // Deeper than anything here is nested nobody reads on.
  constexpr int kDeepest = 8;
  const auto is_shallow = [](int depth, Json::parse_event_t, Json&) { return depth <= kDeepest; };
  const Json read = Json::parse(json, is_shallow, false);
  Reading reading;
  SignedChecklist out = {reading.checklist(read), reading.signature(reading.at(read, "signature"))};
  return reading.is_whole() ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace mlab::preflight
