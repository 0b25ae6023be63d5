// Where things are declared and named.

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>

#include "mlab/assist/place_texts.h"
#include "mlab/assist/targets.h"

namespace mlab::assist {
namespace {

bool has_word(std::string_view text, std::string_view word) {
  const auto is_same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return !std::ranges::search(text, word, is_same).empty();
}

// The outermost declaration around a place.
std::string declaration_around(const std::vector<Symbol>& symbols, std::uint32_t at) {
  for (const Symbol& one : symbols) {
    if (one.span.begin <= at && at < std::max(one.span.end, one.name_span.end)) return one.name;
  }
  return "";
}

}  // namespace

std::optional<Target> Targets::of(const Name& name) {
  if (name.target.source) return Target{file(name.target.source->name()), name.target.span.begin, ""};
  if (name.kind == NameKind::kProcedure && name.is_library) return Target{"", 0, name.text};
  return std::nullopt;
}

const std::string& Targets::file(const std::string& path) {
  const auto [known, is_new] = files_.try_emplace(path);
  if (is_new) known->second = canonical_path(path);
  return known->second;
}

std::vector<Named> named_in(const std::vector<Text>& texts, const Target& target,
                            const Surroundings& around) {
  Targets targets;
  PlaceTexts place_texts(around);
  const bool is_of_components = target.file.ends_with(".cdl") || target.file.ends_with(".cnl");
  std::vector<Named> out;
  for (const Text& text : texts) {
    if (around.given_up && around.given_up()) return out;
    Named one{text, {}};
    const auto add = [&](std::vector<Name> names) {
      for (Name& name : names) {
        if (targets.of(name) == target) one.names.push_back(std::move(name));
      }
    };
    add(names_in(text, around));
    // Only maps and missions have places.
    if (!target.file.empty() && !is_of_components) add(place_texts.in(text));
    if (!one.names.empty()) out.push_back(std::move(one));
  }
  return out;
}

std::optional<Name> named_at(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::vector<Name> names = names_in(text, around);
  if (const Name* const name = name_at(names, within(text, cursor))) return *name;
  const std::vector<Name> places = PlaceTexts(around).in(text);
  const Name* const place = name_at(places, within(text, cursor));
  return place == nullptr ? std::nullopt : std::optional(*place);
}

Surroundings with_project_once(const Surroundings& around) {
  Surroundings out = around;
  if (!around.project) return out;
  out.project = [ask = around.project, known = std::make_shared<std::optional<std::vector<Text>>>()] {
    if (!*known) *known = ask();
    return **known;
  };
  return out;
}

std::vector<Text> texts_with(const std::vector<std::string>& words, const Text& text,
                             const Surroundings& around) {
  std::vector<Text> out{text};
  if (!around.project) return out;
  std::set<std::string> seen{canonical_path(text.source->name())};
  for (Text& other : around.project()) {
    const bool may_name = std::ranges::any_of(
        words, [&](const std::string& word) { return has_word(other.source->text(), word); });
    if (may_name && seen.insert(canonical_path(other.source->name())).second) out.push_back(std::move(other));
  }
  return out;
}

bool is_renamable(const Name& name) {
  return name.target.source && name.kind != NameKind::kFile && !name.is_library &&
         !name.target.source->name().starts_with("library/");
}

std::optional<text::Place> definition(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::optional<Name> name = named_at(text, cursor, around);
  return name && name->target.source ? std::optional(name->target) : std::nullopt;
}

Uses uses(const Text& text, std::uint32_t cursor, const Surroundings& surroundings) {
  const Surroundings around = with_project_once(surroundings);
  const std::optional<Name> name = named_at(text, cursor, around);
  const std::optional<Target> target = name ? Targets().of(*name) : std::nullopt;
  if (!target) return {};
  Uses out{name->text, std::string(name_of(name->kind)), name->is_library, {}};
  for (const Named& one : named_in(texts_with({name->text}, text, around), *target, around)) {
    const std::vector<Symbol> declarations = symbols(one.text, around);
    for (const Name& at : one.names) {
      out.places.push_back({{one.text.source, at.span},
                            std::string(name_of(at.kind)),
                            at.is_declaration,
                            declaration_around(declarations, at.span.begin)});
    }
  }
  return out;
}

std::optional<text::Span> renamable(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::optional<Name> name = named_at(text, cursor, around);
  return name && is_renamable(*name) && !name->is_unsaid ? std::optional(name->span) : std::nullopt;
}

}  // namespace mlab::assist
