#pragma once

#include <cstdint>
#include <memory>
#include <string>

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

}  // namespace mlab::bench
