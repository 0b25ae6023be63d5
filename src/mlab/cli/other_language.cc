#include "mlab/cli/other_language.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include <fmt/core.h>

#include "mlab/text/source.h"

namespace mlab::cli {

using assist::Language;

std::string other_language(const std::string& file, std::initializer_list<Language> wanted) {
  const std::optional<Language> language = assist::language_of(text::Source(file, ""));
  if (!language || std::ranges::count(wanted, *language) > 0) return "";
  const std::filesystem::path path(file);
  const std::string name = path.filename().string();
  switch (*language) {
    case Language::kMission:
      return fmt::format("{} is a mission; `mlab run` carries it out", file);
    case Language::kOverlay:
      return fmt::format("{} is an overlay, a map; a mission names it: OVERLAY \"{}\"", file, name);
    case Language::kNetwork:
      return fmt::format("{} is a network, a robot's program; a mission names it: NEW-ROBOT {} \"{}\"", file,
                         path.stem().string(), name);
    case Language::kConfiguration:
      return fmt::format("{} is a configuration, a robot's program; a mission names it: NEW-ROBOT {} \"{}\"",
                         file, path.stem().string(), name);
    case Language::kEnvironment:
      return fmt::format("{} says how a world changes; `mlab run MISSION --environment {}` takes it", file,
                         file);
  }
  return "";
}

}  // namespace mlab::cli
