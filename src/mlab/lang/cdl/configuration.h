#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::cdl {

/// Files may use each other this deep.
inline constexpr int kMaxUseDepth = 64;

/// What a configuration may name besides its own files.
struct Environment {
  std::vector<std::shared_ptr<const Tree>> built_in;  ///< the component library; known without `use`
  const text::Files* files = nullptr;                 ///< null: those on disk
};

/// A file, all that it uses, and what their names stand for. Own declarations hide those of the library.
struct Configuration {
  text::SourcePtr source;
  std::vector<std::shared_ptr<const Tree>> trees;  ///< the file itself, then those it uses
  std::vector<std::shared_ptr<const Tree>> built_in;
  std::vector<std::shared_ptr<const cnl::Tree>> procedures;  ///< of the CNL files that are used
  std::vector<std::string> files;  ///< paths of all files that were read besides the first

  template <class Kind>
  using Table = std::map<std::string, const Kind*, std::less<>>;
  Table<Assemblage> assemblages;
  Table<Binding> bindings;
  Table<RobotClass> classes;
  Table<Robot> robots;
  Table<SocietyOperator> operators;
  Table<Society> societies;
  std::string architecture;  ///< empty: none said

  Table<Assemblage> built_in_assemblages;          ///< those of the library, hidden or not
  std::set<const text::Source*> built_in_sources;  ///< the library's files
  /// What the name of an assemblage means where it is written: for the library's own files, always the
  /// library's. Null where there is none.
  const Assemblage* assemblage_named(const Word& name) const;

  /// Of the file and those it uses, in the order of the text.
  std::vector<const Robot*> own_robots;
  std::vector<const Assemblage*> own_assemblages;
  std::vector<const RobotClass*> own_classes;
  std::vector<const Society*> own_societies;
  std::vector<const SocietyOperator*> own_operators;
};

/// Reads a configuration, or sentences of G (`formula.h`), and all files that it uses, and collects their
/// declarations.
///
/// @errors  those of `parse` and of the CNL loader; `cannot-read`, `use-cycle`, `use-too-deep`,
///          `unknown-language` for a used file that is neither CDL nor CNL; `duplicate-declaration`
Configuration load(const text::SourcePtr& source, const Environment& environment, text::Diagnostics& sink);

/// The same for a tree that is there already (made by a program, or parsed elsewhere). It must outlive the
/// result.
Configuration configuration_of(std::shared_ptr<const Tree> tree, const Environment& environment,
                               text::Diagnostics& sink);

/// The robot that a mission's NEW-ROBOT means: the one named behind `#`, else the one of the type's name
/// (letter case aside), else the only one.
/// @param wanted     empty: none was named
/// @param type_name  of the mission
/// @errors  `unknown-robot`, `several-robots`, `no-robot` at `place`
const Robot* robot_meant(const Configuration& configuration, std::string_view wanted,
                         std::string_view type_name, const text::Place& place, text::Diagnostics& sink);

/// The society that a mission's NEW-ROBOT means by the name behind `#`.
/// @return  null where it means a robot, or nothing
/// @errors  `unknown-robot` at `place` where there is neither; a warning where there are both
const Society* society_meant(const Configuration& configuration, std::string_view wanted,
                             const text::Place& place, text::Diagnostics& sink);

/// Operators of the society that the robot is in, from the outside in; empty where it is in none.
std::vector<const SocietyOperator*> operators_of(const Configuration& configuration, const Robot& robot);

/// Societies of societies: so many in each other.
inline constexpr std::size_t kMaxSocietyDepth = 500;
/// The robots of a society with how many there are of each, in the order of the text.
/// @return  nothing where there are more than kMostRobotsOfASociety, or it takes too long to count them
std::optional<std::vector<std::pair<const Robot*, int>>> members_of(const Configuration& configuration,
                                                                    const Society& society);

template <class Kind>
std::vector<std::string> names_in(const std::map<std::string, const Kind*, std::less<>>& table) {
  std::vector<std::string> out;
  out.reserve(table.size());
  for (const auto& [name, what] : table) out.push_back(name);
  return out;
}

}  // namespace mlab::cdl
