#include "mlab/assist/service.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "mlab/assist/languages.h"

namespace mlab::assist {

const Name* name_at(const std::vector<Name>& names, std::uint32_t cursor) {
  const Name* behind = nullptr;
  for (const Name& name : names) {
    if (name.span.begin <= cursor && cursor < name.span.end) return &name;
    if (name.span.end == cursor) behind = &name;
    if (name.span.begin > cursor) break;
  }
  return behind;
}

std::uint32_t within(const Text& text, std::uint32_t cursor) {
  return std::min(cursor, static_cast<std::uint32_t>(text.source->text().size()));
}

std::string canonical_path(const std::string& path) {
  std::error_code failure;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, failure);
  return failure ? path : canonical.string();
}

std::vector<Name> names_in(const Text& text, const Surroundings& around) {
  switch (text.language) {
    case Language::kConfiguration:
      return names_cdl(text, around);
    case Language::kNetwork:
      return names_cnl(text, around);
    case Language::kMission:
      return names_mdl(text, around);
    case Language::kOverlay:
      return names_odl(text, around);
    case Language::kEnvironment:
      break;
  }
  return {};
}

Completions complete(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  cursor = within(text, cursor);
  switch (text.language) {
    case Language::kConfiguration:
      return complete_cdl(text, cursor, around);
    case Language::kNetwork:
      return complete_cnl(text, cursor, around);
    case Language::kMission:
      return complete_mdl(text, cursor, around);
    case Language::kOverlay:
      return complete_odl(text, cursor, around);
    case Language::kEnvironment:
      break;
  }
  return {{cursor, cursor}, {}, false};
}

std::optional<Signature> signature(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  if (text.language != Language::kConfiguration) return std::nullopt;
  return signature_cdl(text, within(text, cursor), around);
}

std::optional<Hover> hover(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  cursor = within(text, cursor);
  switch (text.language) {
    case Language::kConfiguration:
      return hover_cdl(text, cursor, around);
    case Language::kNetwork:
      return hover_cnl(text, cursor, around);
    case Language::kMission:
      return hover_mdl(text, cursor, around);
    case Language::kOverlay:
      return hover_odl(text, cursor, around);
    case Language::kEnvironment:
      break;
  }
  return std::nullopt;
}

std::vector<Symbol> symbols(const Text& text, const Surroundings& around) {
  switch (text.language) {
    case Language::kConfiguration:
      return symbols_cdl(text, around);
    case Language::kNetwork:
      return symbols_cnl(text, around);
    case Language::kMission:
      return symbols_mdl(text, around);
    case Language::kOverlay:
      return symbols_odl(text, around);
    case Language::kEnvironment:
      break;
  }
  return {};
}

std::vector<Hint> hints(const Text& text, const Surroundings& around) {
  std::vector<Hint> out;
  if (text.language == Language::kConfiguration) out = hints_cdl(text, around);
  if (text.language == Language::kNetwork) out = hints_cnl(text, around);
  if (text.language == Language::kMission) out = hints_mdl(text, around);
  std::ranges::stable_sort(out, {}, &Hint::at);
  return out;
}

namespace {

std::vector<Shade> tokens_in(const Text& text) {
  switch (text.language) {
    case Language::kConfiguration:
      return tokens_cdl(text);
    case Language::kNetwork:
      return tokens_cnl(text);
    case Language::kMission:
      return tokens_mdl(text);
    case Language::kOverlay:
      return tokens_odl(text);
    case Language::kEnvironment:
      break;
  }
  return {};
}

Shade::Kind shade_of(NameKind kind) {
  switch (kind) {
    case NameKind::kAssemblage:
    case NameKind::kProcedure:
    case NameKind::kBinding:
    case NameKind::kOperator:
      return Shade::Kind::kFunction;
    case NameKind::kClass:
    case NameKind::kType:
    case NameKind::kRobotType:
      return Shade::Kind::kType;
    case NameKind::kRobot:
    case NameKind::kSociety:
    case NameKind::kTeam:
    case NameKind::kPlace:
    case NameKind::kArchitecture:
    case NameKind::kModule:
      return Shade::Kind::kThing;
    case NameKind::kParameter:
    case NameKind::kArgument:
      return Shade::Kind::kParameter;
    case NameKind::kLet:
    case NameKind::kNode:
      return Shade::Kind::kVariable;
    case NameKind::kState:
    case NameKind::kDevice:
    case NameKind::kBodySetting:
    case NameKind::kWord:
    case NameKind::kPercept:
    case NameKind::kLabel:
      return Shade::Kind::kMember;
    case NameKind::kUnit:
      return Shade::Kind::kUnit;
    case NameKind::kFile:
    case NameKind::kTest:
    case NameKind::kTitle:
      return Shade::Kind::kText;
  }
  return Shade::Kind::kVariable;
}

}  // namespace

std::vector<Shade> shades(const Text& text, const Surroundings& around) {
  std::vector<Shade> all;
  for (const Name& name : names_in(text, around)) {
    if (name.kind != NameKind::kFile)
      all.push_back({name.span, shade_of(name.kind), name.is_declaration, name.is_library});
  }
  // Names come first, so that they win where both stand at the same place.
  for (const Shade& token : tokens_in(text)) all.push_back(token);
  std::ranges::stable_sort(all, {}, [](const Shade& one) { return one.span.begin; });
  std::vector<Shade> out;
  for (const Shade& one : all) {
    if (one.span.begin >= one.span.end || (!out.empty() && one.span.begin < out.back().span.end)) continue;
    out.push_back(one);
  }
  return out;
}

}  // namespace mlab::assist
