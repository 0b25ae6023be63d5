#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/lang/cdl_historic/tree.h"

namespace mlab::cdl_historic {

/// The settings of one group or instance by their names, without those of lists.
using SettingsByName = std::map<std::string, std::vector<const Setting*>, std::less<>>;
SettingsByName by_name(const std::vector<Setting>& settings);

/// One group or instance on the way from a robot down to a node, with what it sets. Values are looked for
/// from the outermost level inwards: who stands further out wins.
struct Level {
  const Level* outer = nullptr;
  const SettingsByName* settings = nullptr;
  int depth = 0;  ///< outermost: 1
};

/// A value and the level that sets it, in whose scope it counts.
struct BoundValue {
  const Value* value = nullptr;
  const Level* level = nullptr;
  /// Text of a `{& %a %b}`, put together; then there is no value.
  std::optional<std::string> joined;
};

/// What a pushed-up parameter is set to, seen from a node.
///
/// @param name       without `%`
/// @param is_pushed  asked for as `%name`: an ordinary parameter of that name does not count
/// @return  nothing where no level sets it
std::optional<BoundValue> look_up(const Level* level, std::string_view name, bool is_pushed);
/// What stands behind a `{^...}` of the parameter `own_name`.
std::optional<BoundValue> look_up(const Level* level, const PushedUp& up, std::string_view own_name);

}  // namespace mlab::cdl_historic
