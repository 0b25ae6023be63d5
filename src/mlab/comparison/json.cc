#include <cmath>

#include <nlohmann/json.hpp>

#include "mlab/comparison/report.h"
#include "mlab/comparison/words.h"

namespace mlab::comparison {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;

// What is no number can't stand in JSON.
Json number(double value) {
  return std::isfinite(value) ? Json(std::round(value * 1e6) / 1e6) : Json(nullptr);
}

Json optional_words(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

// The fields of both, as `a` and `b`.
template <class T, class Of>
Json both(const Both<T>& values, Of of) {
  return {{"a", of(values[0])}, {"b", of(values[1])}};
}

Json side_json(const Side& side) {
  return {{"file", side.name},
          {"mission", side.mission},
          {"version", side.version},
          {"seed", side.seed},
          {"cycles", side.cycles},
          {"simulated_s", number(side.length)},
          {"outcome", optional_words(side.outcome)},
          {"why_not_recomputed", optional_words(side.why_not_recomputed)},
          {"remarks", side.remarks}};
}

Json beginning_json(const Beginning& beginning) {
  Json facts = Json::array();
  for (const Fact& fact : beginning.facts)
    facts.push_back({{"what", fact.what},
                     {"a", optional_words(fact.values[0])},
                     {"b", optional_words(fact.values[1])},
                     {"matters", fact.matters}});
  Json texts = Json::array();
  for (const TextDifference& text : beginning.texts)
    texts.push_back({{"a", optional_words(text.paths[0])},
                     {"b", optional_words(text.paths[1])},
                     {"lines", text.lines},
                     {"lines_left_out", text.left_out}});
  return {{"facts", std::move(facts)}, {"texts", std::move(texts)}};
}

const char* name_of(Parting::What what) {
  switch (what) {
    case Parting::What::kPort:
      return "port";
    case Parting::What::kState:
      return "state";
    case Parting::What::kAction:
      return "action";
    case Parting::What::kPlace:
      return "place";
    case Parting::What::kRobots:
      return "robots";
    case Parting::What::kMission:
      return "mission";
    case Parting::What::kEnd:
      return "end";
  }
  return "";
}

Json value_json(const Value& value) {
  return {
      {"path", value.path}, {"a", optional_words(value.values[0])}, {"b", optional_words(value.values[1])}};
}

Json parting_json(const Parting& parting) {
  Json out = {{"what", name_of(parting.what)},
              {"cycle", parting.cycle},
              {"time_s", number(parting.time)},
              {"robot", parting.robot == 0 ? Json(nullptr) : Json(parting.robot)},
              {"value", value_json(parting.value)},
              {"causes", parting.causes}};
  out["consequences"] = Json::array();
  for (const Value& value : parting.consequences) out["consequences"].push_back(value_json(value));
  out["values"] = parting.values;
  out["robots"] = parting.robots;
  out["same_until"] = parting.same_until ? Json(*parting.same_until) : Json(nullptr);
  return out;
}

Json robot_json(const RobotRow& row, bool is_recomputed) {
  Json out = {{"id", row.id}, {"is_there", both(row.is_there, [](bool there) { return Json(there); })}};
  out["are_values_compared"] = is_recomputed && row.has_values && row.is_there[0] && row.is_there[1];
  out["most_apart_m"] = number(row.most_apart);
  out["most_apart_at_s"] = number(row.most_apart_at);
  out["apart_at_end_m"] = number(row.apart_at_end);
  if (is_recomputed) {
    out["distance_m"] = both(row.driven, number);
    out["contacts"] = both(row.contacts, [](std::uint32_t contacts) { return Json(contacts); });
    out["first_contact_s"] = both(row.first_contact, [](const std::optional<double>& time) {
      return time ? number(*time) : Json(nullptr);
    });
  }
  out["apart_m"] = Json::array();
  for (const float apart : row.apart) out["apart_m"].push_back(number(static_cast<double>(apart)));
  return out;
}

Json command_json(const CommandRow& row) {
  Json out = {{"what", row.what}};
  out.update(both(row.times, [](const std::optional<CommandRow::Times>& times) -> Json {
    if (!times) return nullptr;
    return {{"start_s", number(times->start)},
            {"end_s", times->has_ended ? number(times->end) : Json(nullptr)},
            {"outcome", times->outcome}};
  }));
  return out;
}

Json unit_json(const UnitRow& row) {
  Json out = {{"name", row.name}};
  out.update(both(row.errors, [](const std::optional<UnitRow::Error>& error) -> Json {
    if (!error) return nullptr;
    return {{"mean_m", number(error->mean)},
            {"max_m", number(error->most)},
            {"out_of_formation_share", number(error->out_share)}};
  }));
  return out;
}

Json event_json(const EventRow& row) {
  Json out = {{"text", row.text}, {"is_warning", row.is_warning}};
  out.update(both(row.times,
                  [](const std::optional<double>& time) { return time ? number(*time) : Json(nullptr); }));
  return out;
}

template <class Rows, class Of>
Json list(const Rows& rows, Of of) {
  Json out = Json::array();
  for (const auto& row : rows) out.push_back(of(row));
  return out;
}

}  // namespace

std::string json_of(const Comparison& comparison) {
  Json out;
  out["version"] = kSchemaVersion;
  out["same"] = comparison.is_same();
  out["verdict"] = verdict(comparison);
  out["runs"] = both(comparison.sides, side_json);
  out["is_recomputed"] = comparison.is_recomputed;
  out["is_whole"] = comparison.is_whole;
  out["beginning"] = beginning_json(comparison.beginning);
  out["input"] = nullptr;
  if (const auto& input = comparison.input) {
    out["input"] = {{"cycle", input->cycle}, {"time_s", number(input->time)}};
    out["input"].update(both(input->inputs, optional_words));
  }
  out["parting"] = comparison.parting ? parting_json(*comparison.parting) : Json(nullptr);
  out["times_s"] = list(comparison.times, number);
  out["robots"] =
      list(comparison.robots, [&](const RobotRow& row) { return robot_json(row, comparison.is_recomputed); });
  out["commands"] = list(comparison.commands, command_json);
  out["units"] = list(comparison.units, unit_json);
  out["events"] = list(comparison.events, event_json);
  out["events_left_out"] = comparison.events_left_out;
  // Names and texts of strangers may be any bytes.
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mlab::comparison
