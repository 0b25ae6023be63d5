#include "mlab/lang/cdl_historic/scope.h"

#include <algorithm>
#include <set>

namespace mlab::cdl_historic {
namespace {

using Names = std::set<std::string, std::less<>>;

std::optional<BoundValue> search(const std::vector<const Level*>& levels, const std::string& name,
                                 bool is_pushed, Names& tried);

std::optional<BoundValue> follow(const std::vector<const Level*>& levels, const PushedUp& up, Names& tried) {
  if (up.second.text.empty()) return search(levels, up.name.text, true, tried);
  std::string joined;
  for (const Word* part : {&up.name, &up.second}) {
    Names own = tried;
    const std::optional<BoundValue> found = search(levels, part->text, true, own);
    if (!found || (!found->joined && found->value->kind != Value::Kind::kConstant)) return std::nullopt;
    if (!joined.empty()) joined += ",";
    joined += found->joined ? *found->joined : found->value->constant.text;
  }
  return BoundValue{nullptr, levels.empty() ? nullptr : levels.back(), joined};
}

std::optional<BoundValue> search(const std::vector<const Level*>& levels, const std::string& name,
                                 bool is_pushed, Names& tried) {
  if (!tried.insert(name).second) return std::nullopt;  // two levels that point at each other
  for (const Level* level : levels) {
    const auto it = level->settings->find(name);
    if (it == level->settings->end()) continue;
    for (const Setting* setting : it->second) {
      if (is_pushed && !setting->is_pushed) continue;
      const Value& value = setting->value;
      if (value.kind == Value::Kind::kNone || value.kind == Value::Kind::kBare) continue;
      if (value.kind != Value::Kind::kPushedUp) return BoundValue{&value, level, std::nullopt};
      if (value.up.name.text.empty() || (value.up.name.text == name && value.up.second.text.empty()))
        continue;
      if (auto found = follow(levels, value.up, tried)) return found;
    }
  }
  return std::nullopt;
}

std::vector<const Level*> outermost_first(const Level* level) {
  std::vector<const Level*> levels;
  for (; level != nullptr; level = level->outer) levels.push_back(level);
  std::ranges::reverse(levels);
  return levels;
}

}  // namespace

SettingsByName by_name(const std::vector<Setting>& settings) {
  SettingsByName out;
  for (const Setting& setting : settings) {
    if (!setting.name.text.empty() && setting.index.text.empty()) out[setting.name.text].push_back(&setting);
  }
  return out;
}

std::optional<BoundValue> look_up(const Level* level, std::string_view name, bool is_pushed) {
  Names tried;
  return search(outermost_first(level), std::string(name), is_pushed, tried);
}

std::optional<BoundValue> look_up(const Level* level, const PushedUp& up, std::string_view own_name) {
  Names tried;
  const std::vector<const Level*> levels = outermost_first(level);
  if (up.name.text.empty()) return search(levels, std::string(own_name), false, tried);
  return follow(levels, up, tried);
}

}  // namespace mlab::cdl_historic
