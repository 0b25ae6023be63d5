// `mlab world`: maps that are drawn by a seed, for studies.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/input.h"
#include "mlab/cli/option_groups.h"
#include "mlab/cli/places.h"
#include "mlab/lang/odl/drawn_worlds.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

int refuse_world(const std::string& why) {
  fmt::print(stderr, "mlab world: {}\n", why);
  return kBadInput;
}

}  // namespace

std::vector<std::string> world_kinds() {
  std::vector<std::string> out;
  for (const odl::WorldKindInfo& one : odl::kWorldKinds) out.emplace_back(one.name);
  return out;
}

std::string world_kinds_help() {
  std::string out = "what it is like:";
  for (const odl::WorldKindInfo& one : odl::kWorldKinds) out += fmt::format("\n  {}: {}", one.name, one.help);
  return out;
}

void add_world(CLI::App& app, WorldOptions& o) {
  CLI::App* c = app.add_subcommand("world", kWorldDescription);
  c->add_option("kind", o.kind, world_kinds_help())
      ->required()
      ->check(CLI::IsMember(world_kinds()))
      ->type_name("KIND");
  c->add_option("--seed", o.seed, "of the first map; the others follow")
      ->capture_default_str()
      ->type_name("N");
  c->add_option("--count", o.count, "how many maps")
      ->capture_default_str()
      ->check(CLI::Range(1U, 100'000U))
      ->type_name("N");
  c->add_option("--folder", o.folder, "where to, made where it isn't there; other files are left alone")
      ->type_name("FOLDER");
}

int draw_worlds(const WorldOptions& options) {
  const auto kind = static_cast<odl::WorldKind>(
      std::ranges::find(odl::kWorldKinds, options.kind, &odl::WorldKindInfo::name) -
      odl::kWorldKinds.begin());
  const auto text = [&](std::uint64_t seed) {
    return odl::text_of(odl::drawn_world(kind, seed), kind, seed);
  };
  if (options.folder.empty()) {
    if (options.count != 1) return refuse_world("several maps go into files; say where with --folder");
    fmt::print("{}", text(options.seed));
    return kDone;
  }
  const auto file = [&](std::uint64_t seed) {
    return (fs::path(options.folder) / fmt::format("{}_{}.odl", options.kind, seed)).string();
  };
  std::error_code error;
  fs::create_directories(options.folder, error);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t i = 0; i < options.count; ++i) {
    const std::uint64_t seed = options.seed + i;
    if (!fs::exists(fs::symlink_status(file(seed), error))) {
      missing.push_back(seed);
      continue;
    }
    const auto before = read_input(file(seed));
    if (!before || (*before)->text() != text(seed))
      return refuse_world(
          fmt::format("{} is there already, and is another one; nothing was written", file(seed)));
  }
  for (const std::uint64_t seed : missing) {
    if (!write_file(file(seed), text(seed)))
      return refuse_world(fmt::format("{} can't be written{}", file(seed), why_not_written()));
  }
  fmt::print("{}: {} to {}\n", base::counted(options.count, "map"), file(options.seed),
             file(options.seed + options.count - 1));
  return kDone;
}

}  // namespace mlab::cli
