#include "mlab/cli/run_settings.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/fleet_runner.h"
#include "mlab/cli/files.h"
#include "mlab/cli/fleet_machines.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/fleet_stop.h"
#include "mlab/cli/fleet_vehicles.h"
#include "mlab/cli/fleet_words.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/library/library.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/run/pace.h"
#include "mlab/study/dimension.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

// Times real time; 0: as fast as it goes.
std::optional<double> speed_of(const std::string& text, double default_speed) {
  if (text.empty()) return default_speed;
  if (text == "max") return 0.0;
  if (text == "real") return 1.0;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= run::Pace::kSlowest) ||
      value > run::Pace::kFastest)
    return std::nullopt;
  return value;
}

// The files that the run leaves behind can be written, and nothing that it reads is among them.
bool outputs_are_usable(const RunOptions& options) {
  const std::string problem =
      problem_with_outputs(outputs_of(options), {{"mission", options.mission},
                                                 {"file of --environment", options.environment},
                                                 {"file of --percepts", options.percepts}});
  if (!problem.empty()) {
    usage_error(problem);
    return false;
  }
  std::error_code unknown;
  if (!options.record.empty() && std::filesystem::exists(options.record, unknown)) {
    usage_error(fmt::format(
        "--record {}: there is such a file already, and a recording is never written over", options.record));
    return false;
  }
  if (!options.record.empty() && !options.percepts.empty()) {
    usage_error("--record and --percepts: what comes out of a file is not recorded once more");
    return false;
  }
  return true;
}

// As others in the fleet know it.
std::string name_of_run(const RunOptions& options) {
  const std::string mission = std::filesystem::path(options.mission).stem().string();
  return fmt::format("{}{} on {}", mission.empty() ? "console" : "run ", text::shown(mission),
                     stopping_person());
}

// Where the robots of the run are, and whether they are waited for.
std::optional<std::string> settle_robots(const RunOptions& options, RunManner& out) {
  const NetworkOptions& network = options.network;
  if (!options.unchecked.empty() && !options.real_time)
    return "--unchecked counts with --real-time only: nothing else drives vehicles";
  if (options.robots != RobotsAt::kFleet) {
    if (!network.fleet.empty() || !network.interface_name.empty() || !network.peers.empty() ||
        network.is_secure)
      return "--fleet, --network, --peer and --secure count with --robots fleet only";
    if (options.real_time)
      return "--real-time counts with --robots fleet only: all other robots are waited for";
    return std::nullopt;
  }
  if (options.real_time) {
    if (!options.speed.empty() && out.speed != 1.0)
      return fmt::format("--speed {} can't be had with --real-time: time passes as on the clock",
                         options.speed);
    out.speed = 1.0;
    out.settings.is_in_real_time = true;
    out.settings.stands_still_for_operator = false;
  }
  const auto reached = network_of(network);
  if (!reached) return reached.error();
  const auto roster = agents::Roster::join(*reached);
  if (!roster) return roster.error();
  auto stop_line = fleet_stop_line(*roster, name_of_run(options), identity_folder(network));
  if (!stop_line) return stop_line.error();
  out.settings.stop_line = std::move(*stop_line);
  out.machines = watch_machines(*roster, network);
  const agents::StartHints hints{fleet_options(network), fleet_options_elsewhere(network),
                                 who_is_not_seen(network)};
  out.settings.robots_elsewhere = [roster = *roster, hints, is_live = options.real_time](
                                      std::uint64_t seed, double cycle_duration) {
    return agents::make_fleet_runner(roster, seed, kVersion, is_live ? cycle_duration : 0.0, hints);
  };
  if (options.real_time) out.gate = settle_vehicles(*roster, options, out.settings);
  return std::nullopt;
}

}  // namespace

std::vector<NamedFile> outputs_of(const RunOptions& options) {
  return {{"--report", options.report},
          {"--plot", options.plot},
          {"--save-percepts", options.save_percepts},
          {"--record", options.record}};
}

std::vector<NamedFile> files_read_for(const mission::Mission& mission, const run::Crew* crew) {
  std::vector<NamedFile> out;
  // As it is written from here, or from the mission's folder.
  const auto add = [&](const std::string& file) {
    std::error_code unknown;
    for (const std::filesystem::path& path :
         {std::filesystem::path(file), mission.folder / std::filesystem::path(file)}) {
      if (!file.empty() && std::filesystem::exists(path, unknown))
        out.push_back({"file of the mission", path.string()});
    }
  };
  const auto add_text = [&](const text::SourcePtr& text) {
    if (text) add(std::string(text->name()));
  };
  add_text(mission.source);
  std::ranges::for_each(mission.texts, add_text);
  if (crew != nullptr) std::ranges::for_each(run::texts_of(*crew), add_text);
  for (const mission::RobotType& type : mission.types) {
    const bool is_of_library =
        !library::find_robot(std::filesystem::path(type.program).filename().string()).empty();
    if (!is_of_library) add(type.program);
  }
  add(mission.overlay.map_file);
  if (mission.overlay.map_picture) add(mission.overlay.map_picture->file);
  if (mission.overlay.height_map) add(mission.overlay.height_map->file);
  return out;
}

std::optional<RunManner> run_manner(const RunOptions& options, double default_speed) {
  const std::optional<double> speed = speed_of(options.speed, default_speed);
  if (!speed) {
    usage_error(fmt::format("--speed {}: expected real, max, or a number from {} to {}", options.speed,
                            run::Pace::kSlowest, run::Pace::kFastest));
    return std::nullopt;
  }
  const std::optional<MissionClock> clock =
      options.start_time.empty() ? wall_clock() : parse_start_time(options.start_time);
  if (!clock) {
    usage_error(
        fmt::format("--start-time {}: expected YYYY-MM-DD HH:MM or YYYY-MM-DD HH:MM:SS", options.start_time));
    return std::nullopt;
  }
  if (!outputs_are_usable(options)) return std::nullopt;
  RunManner out;
  out.speed = *speed;
  out.clock = *clock;
  out.settings.seed = options.seed;
  out.settings.threads = options.threads;
  out.settings.stands_still_for_operator = *speed == 0.0;
  out.settings.executive.proceed_all = options.proceed;
  out.settings.executive.patience = options.patience;
  out.settings.executive.epoch_seconds = clock->epoch_seconds;
  out.settings.executive.zone_offset = clock->zone_offset;
  if (auto problem = settle_robots(options, out)) {
    usage_error(*problem);
    return std::nullopt;
  }
  return out;
}

robot::ProgramSources mission_sources(const RunOptions& options, const cell::Permission& permission) {
  const std::string folder = std::filesystem::path(options.mission).parent_path().string();
  robot::ProgramSources out = program_sources(folder, permission);
  out.limits = options.limits;
  out.in_own_processes = options.robots == RobotsAt::kOwnProcesses;
  out.project = !options.project.empty() ? options.project : folder.empty() ? "." : folder;
  return out;
}

text::Diagnostics told_of_run(const text::Diagnostics& all, const RunOptions& options) {
  const bool is_complete = all.items().size() == all.error_count() + all.warning_count() + all.note_count();
  if (options.robots != RobotsAt::kFleet || !is_complete) return all;
  text::Diagnostics out;
  for (const text::Diagnostic& one : all.items()) {
    if (one.kind != "host-needs-fleet") out.report(one);
  }
  return out;
}

mdl::LoadOptions load_options(const RunOptions& options, robot::ProgramSources sources) {
  mdl::LoadOptions out;
  out.seed = options.seed;
  out.overlay_folders = overlay_folders();
  out.societies = robot::society_reader(std::move(sources));
  return out;
}

std::optional<std::vector<mdl::Setting>> settings_of(const RunOptions& options) {
  std::vector<mdl::Setting> out;
  if (!options.set.empty() && !options.headless) {
    usage_error("--set counts with --headless: the console has sliders for parameters");
    return std::nullopt;
  }
  for (const std::string& text : options.set) {
    auto setting = study::setting_of(text);
    if (!setting) {
      tell(setting.error());
      return std::nullopt;
    }
    if (std::ranges::find(out, setting->name, &mdl::Setting::name) != out.end()) {
      usage_error(fmt::format("--set {}: `{}` is set twice", text::shown(text, 100),
                              text::shown(setting->name, 100)));
      return std::nullopt;
    }
    out.push_back(std::move(*setting));
  }
  return out;
}

int usage_error(const std::string& message) {
  fmt::print(stderr, "mlab run: {}\n", message);
  return kBadInput;
}

bool deliver(const char* command, const char* what, const std::string& file, const std::string& text) {
  if (!write_file(file, text, was_interrupted)) {
    fmt::print(stderr, "{}: the {} {} could not be written{}\n", command, what, file, why_not_written());
    return false;
  }
  fmt::print("{}: {}\n", what, file);
  return true;
}

}  // namespace mlab::cli
