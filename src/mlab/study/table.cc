#include "mlab/study/table.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "mlab/text/escape.h"

namespace mlab::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTableFormat = 1;

/// One column of both tables.
struct Column {
  std::string name;
  std::function<Json(const Row&, const std::vector<mdl::Setting>&)> value;
};

const std::string& mission_of(std::uint32_t version, const Definition& definition) {
  return version == 0 ? definition.mission.text : definition.against.text;
}

std::vector<Column> columns_of(const Summary& summary, const Definition& definition, const Plan& plan) {
  using Settings = std::vector<mdl::Setting>;
  std::vector<Column> out;
  const auto add = [&](std::string name, auto value) { out.push_back({std::move(name), std::move(value)}); };
  add("mission",
      [&](const Row& row, const Settings&) { return Json(mission_of(row.key.version, definition)); });
  add("combination", [](const Row& row, const Settings&) { return Json(row.key.combination + 1); });
  for (std::size_t i = 0; i < definition.dimensions.size(); ++i)
    add(definition.dimensions[i].name.text,
        [i](const Row&, const Settings& settings) { return Json(settings[i].value); });
  add("seed", [](const Row& row, const Settings&) { return Json(row.seed); });
  add("success", [](const Row& row, const Settings&) { return Json(row.success); });
  add("outcome", [](const Row& row, const Settings&) { return Json(row.outcome); });
  for (const NumberInfo& info : kNumbers) {
    add(column(info), [number = info.number](const Row& row, const Settings&) {
      return std::isnan(row[number]) ? Json(nullptr) : Json(row[number]);
    });
  }
  add("cause", [](const Row& row, const Settings&) { return row.success ? Json(nullptr) : Json(row.cause); });
  add("message",
      [](const Row& row, const Settings&) { return row.success ? Json(nullptr) : Json(row.message); });
  add("repeat", [&](const Row& row, const Settings&) {
    return row.success ? Json(nullptr) : Json(command_of(row.key, definition, plan));
  });
  std::map<RunKey, std::string> recordings;
  for (const FailureGroup& group : summary.failures) {
    if (!group.recording.empty()) recordings.emplace(group.first, group.recording);
  }
  add("recording", [recordings = std::move(recordings)](const Row& row, const Settings&) {
    const auto found = recordings.find(row.key);
    return found == recordings.end() ? Json(nullptr) : Json(found->second);
  });
  return out;
}

std::string csv_field(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return text::csv_field(value.get<std::string>());
  if (value.is_number_float()) return shortest(value.get<double>());
  return value.dump();
}

Json settings_json(const std::vector<mdl::Setting>& settings) {
  Json out = Json::object();
  for (const mdl::Setting& one : settings) out[one.name] = one.value;
  return out;
}

Json sample_json(const statistics::Sample& sample) {
  if (sample.empty()) return nullptr;
  return {{"runs", sample.size()},
          {"mean", sample.mean},
          {"deviation", sample.deviation},
          {"min", sample.sorted.front()},
          {"p5", statistics::quantile(sample, 0.05)},
          {"median", statistics::quantile(sample, 0.5)},
          {"p95", statistics::quantile(sample, 0.95)},
          {"max", sample.sorted.back()}};
}

Json cell_json(const CellSummary& cell, const Definition& definition) {
  Json out = {{"mission", mission_of(cell.version, definition)},
              {"combination", cell.combination + 1},
              {"set", settings_json(cell.settings)},
              {"runs", cell.successes.trials},
              {"successes", cell.successes.successes},
              {"low", cell.interval.low},
              {"high", cell.interval.high}};
  const std::vector<NumberInfo> numbers = shown_numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) out[column(numbers[i])] = sample_json(cell.samples[i]);
  return out;
}

Json comparison_json(const Comparison& comparison) {
  Json out = {{"combination", comparison.combination + 1},
              {"pairs", comparison.pairs},
              {"only_mission_succeeds", comparison.successes.only_first},
              {"only_against_succeeds", comparison.successes.only_second},
              {"mcnemar_p", comparison.p}};
  const std::vector<NumberInfo> numbers = shown_numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Comparison::Difference& one = comparison.differences[i];
    out[column(numbers[i])] = {{"pairs", one.pairs},
                               {"different", one.ranks.pairs},
                               {"mean_difference", one.mean},
                               {"median_difference", one.median},
                               {"signed_ranks_p", one.ranks.p},
                               {"is_exact", one.ranks.is_exact}};
  }
  return out;
}

Json summary_json(const Summary& summary, const Definition& definition) {
  Json out;
  out["interval"] = {{"kind", definition.until ? "confidence sequence" : "Clopper-Pearson"},
                     {"confidence", definition.confidence}};
  out["combinations"] = Json::array();
  for (const CellSummary& cell : summary.cells) out["combinations"].push_back(cell_json(cell, definition));
  out["failures"] = Json::array();
  for (const FailureGroup& group : summary.failures)
    out["failures"].push_back(
        {{"cause", group.cause},
         {"runs", group.count},
         {"repeat", group.command},
         {"recording", group.recording.empty() ? Json(nullptr) : Json(group.recording)}});
  out["requirements"] = Json::array();
  for (const Verdict& verdict : summary.verdicts) {
    Json unmet = Json::array();
    for (const std::uint32_t combination : verdict.unmet) unmet.push_back(combination + 1);
    out["requirements"].push_back({{"requirement", verdict.requirement->text},
                                   {"met", verdict.is_met()},
                                   {"unmet_by", std::move(unmet)}});
  }
  if (!summary.comparisons.empty()) {
    out["comparisons"] = Json::array();
    for (const Comparison& one : summary.comparisons) out["comparisons"].push_back(comparison_json(one));
  }
  return out;
}

}  // namespace

std::string csv_of(const Batch& batch, const Summary& summary, const Definition& definition,
                   const Plan& plan) {
  const std::vector<Column> columns = columns_of(summary, definition, plan);
  std::string out;
  for (std::size_t i = 0; i < columns.size(); ++i)
    out += (i > 0 ? "," : "") + text::csv_field(columns[i].name);
  out += "\r\n";
  for (const Cell& cell : batch.cells()) {
    for (const Row& row : cell.rows) {
      const std::vector<mdl::Setting> settings = plan.settings(row.key);
      for (std::size_t i = 0; i < columns.size(); ++i)
        out += (i > 0 ? "," : "") + csv_field(columns[i].value(row, settings));
      out += "\r\n";
    }
  }
  return out;
}

std::string json_of(const Batch& batch, const Summary& summary, const Definition& definition,
                    const Plan& plan, const std::string& program_version) {
  const std::vector<Column> columns = columns_of(summary, definition, plan);
  Json out;
  out["version"] = kTableFormat;
  out["mlab_version"] = program_version;
  out["mission"] = definition.mission.text;
  if (!definition.against.empty()) out["against"] = definition.against.text;
  out["start_time"] = definition.start_time;
  out["summary"] = summary_json(summary, definition);
  out["runs"] = Json::array();
  for (const Cell& cell : batch.cells()) {
    for (const Row& row : cell.rows) {
      const std::vector<mdl::Setting> settings = plan.settings(row.key);
      Json& one = out["runs"].emplace_back(Json::object());
      for (const Column& column : columns) one[column.name] = column.value(row, settings);
    }
  }
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mlab::study
