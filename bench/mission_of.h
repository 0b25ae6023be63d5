#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/source.h"

namespace mlab::bench {

/// A mission whose overlay is called `map.odl`; null where something is wrong with it, which is printed then.
inline std::shared_ptr<const mission::Mission> mission_of(const std::string& mission, const std::string& map,
                                                          std::uint64_t seed) {
  mdl::LoadOptions options;
  options.seed = seed;
  options.files.is_file = [](const std::string& path) { return path.ends_with("map.odl"); };
  options.files.read = [&](const std::string& path) { return std::make_shared<text::Source>(path, map); };
  text::Diagnostics sink;
  auto out = mdl::check_mission(std::make_shared<text::Source>("bench.mdl", mission), "", sink, options);
  if (!out) fmt::print(stderr, "{}\n", text::render(sink));
  return out;
}

/// Writes such a mission and its overlay, so that `mlab` can carry it out: FOLDER/NAME_SEED.mdl,
/// FOLDER/map_SEED.odl.
/// @param mission  its first line names the overlay
inline void write_mission(const std::string& folder, std::string_view name, std::uint64_t seed,
                          const std::string& mission, const std::string& map) {
  std::filesystem::create_directories(folder);
  std::ofstream(fmt::format("{}/{}_{}.mdl", folder, name, seed))
      << fmt::format("OVERLAY map_{}.odl\n", seed) << mission.substr(mission.find('\n') + 1);
  std::ofstream(fmt::format("{}/map_{}.odl", folder, seed)) << map;
}

}  // namespace mlab::bench
