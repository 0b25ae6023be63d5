#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mlab/assist/languages.h"

/// What names of several texts stand for: below uses.cc and renaming.cc.
namespace mlab::assist {

/// What a name stands for: the place where it is declared, or what was compiled in, by its name.
struct Target {
  std::string file;
  std::uint32_t begin = 0;
  std::string name;

  friend bool operator==(const Target&, const Target&) = default;
};

/// Paths are asked of the system once each.
class Targets {
 public:
  std::optional<Target> of(const Name& name);

 private:
  const std::string& file(const std::string& path);
  std::map<std::string, std::string> files_;
};

/// A text of the project, and the names in it that stand for one thing, ascending.
struct Named {
  Text text;
  std::vector<Name> names;
};
/// Texts in which there is none are left out.
std::vector<Named> named_in(const std::vector<Text>& texts, const Target& target, const Surroundings& around);

/// The same, where the project's texts are gathered once, however often they are asked for.
Surroundings with_project_once(const Surroundings& around);

std::optional<Name> named_at(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// The text itself first, then those of the project that one of the words stands in, in any case: elsewhere
/// nothing can be called so.
std::vector<Text> texts_with(const std::vector<std::string>& words, const Text& text,
                             const Surroundings& around);

bool is_renamable(const Name& name);

}  // namespace mlab::assist
