// Where things are declared and named, and giving them other names.

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <fmt/core.h>

#include "mlab/lang/cdl/lexer.h"
#include "mlab/lang/cnl/lexer.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/odl/token.h"
#include "mlab/language/languages.h"
#include "mlab/text/shown.h"

namespace mlab::language {
namespace {

/// What a name stands for: the place where it is declared, or for what was compiled in its name.
struct Target {
  std::string file;
  std::uint32_t begin = 0;
  std::string name;

  friend bool operator==(const Target&, const Target&) = default;
};

/// Paths are asked of the system once each.
class Targets {
 public:
  std::optional<Target> of(const Name& name) {
    if (name.target.source) return Target{file(name.target.source->name()), name.target.span.begin, ""};
    if (name.kind == NameKind::kProcedure && name.is_library) return Target{"", 0, name.text};
    return std::nullopt;
  }

 private:
  const std::string& file(const std::string& path) {
    const auto [known, is_new] = files_.try_emplace(path);
    if (is_new) known->second = canonical_path(path);
    return known->second;
  }

  std::map<std::string, std::string> files_;
};

std::vector<Text> all_texts(const Text& text, const std::vector<Text>& others) {
  std::vector<Text> out{text};
  std::set<std::string> seen{canonical_path(text.source->name())};
  for (const Text& other : others) {
    if (seen.insert(canonical_path(other.source->name())).second) out.push_back(other);
  }
  return out;
}

std::vector<text::Place> places_of(const Target& wanted, const std::vector<Text>& texts,
                                   const Surroundings& around) {
  Targets targets;
  std::vector<text::Place> out;
  for (const Text& text : texts) {
    for (const Name& name : names_in(text, around)) {
      if (targets.of(name) == wanted) out.push_back({text.source, name.span});
    }
  }
  return out;
}

std::optional<Name> named_at(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::vector<Name> names = names_in(text, around);
  const Name* const name = name_at(names, within(text, cursor));
  return name == nullptr ? std::nullopt : std::optional(*name);
}

bool is_renamable(const Name& name) {
  return name.target.source && name.kind != NameKind::kFile && !name.is_library &&
         !name.target.source->name().starts_with("library/");
}

// Missions and overlays have words with `-` in them, and words of their own.
bool is_plain_word(std::string_view name) {
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::ranges::all_of(name,
                             [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; }) &&
         mdl::find_keyword(name) == nullptr && odl::find_keyword(name) == odl::Keyword::kNone;
}

bool is_name_in(Language language, std::string_view name) {
  switch (language) {
    case Language::kConfiguration:
      return cdl::is_name(name);
    case Language::kNetwork:
      return cnl::is_name(name);
    default:
      return is_plain_word(name);
  }
}

text::SourcePtr spliced(const text::SourcePtr& source, const std::vector<Splice>& splices) {
  std::string out;
  std::uint32_t at = 0;
  for (const Splice& splice : splices) {
    out += source->text({at, splice.span.begin});
    out += splice.text;
    at = splice.span.end;
  }
  out += source->text().substr(at);
  return std::make_shared<const text::Source>(source->name(), std::move(out));
}

/// Whether the new name means the same in the same places, and nothing else.
bool keeps_meaning(const std::vector<Text>& texts, const std::vector<Change>& changes, const Target& target,
                   const Surroundings& around) {
  std::map<std::string, text::SourcePtr> changed;
  Target now = target;
  std::size_t places = 0;
  for (const Change& change : changes) {
    const std::string path = canonical_path(change.source->name());
    changed[path] = spliced(change.source, change.splices);
    places += change.splices.size();
    if (path != target.file) continue;
    for (const Splice& splice : change.splices) {
      if (splice.span.begin >= target.begin) break;
      now.begin += static_cast<std::uint32_t>(splice.text.size()) - (splice.span.end - splice.span.begin);
    }
  }
  Surroundings after = around;
  after.files.read = [&](const std::string& path) -> text::Result<text::SourcePtr> {
    const auto found = changed.find(canonical_path(path));
    return found == changed.end() ? around.files.read(path) : found->second;
  };
  std::vector<Text> renamed = texts;
  for (Text& text : renamed) {
    const auto found = changed.find(canonical_path(text.source->name()));
    if (found != changed.end()) text.source = found->second;
  }
  return places_of(now, renamed, after).size() == places;
}

}  // namespace

std::optional<text::Place> definition(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::optional<Name> name = named_at(text, cursor, around);
  return name && name->target.source ? std::optional(name->target) : std::nullopt;
}

std::vector<text::Place> references(const Text& text, std::uint32_t cursor, const std::vector<Text>& others,
                                    const Surroundings& around) {
  const std::optional<Name> name = named_at(text, cursor, around);
  if (!name) return {};
  const std::optional<Target> target = Targets().of(*name);
  return target ? places_of(*target, all_texts(text, others), around) : std::vector<text::Place>{};
}

std::optional<text::Span> renamable(const Text& text, std::uint32_t cursor, const Surroundings& around) {
  const std::optional<Name> name = named_at(text, cursor, around);
  return name && is_renamable(*name) ? std::optional(name->span) : std::nullopt;
}

std::expected<std::vector<Change>, std::string> rename(const Text& text, std::uint32_t cursor,
                                                       const std::string& name,
                                                       const std::vector<Text>& others,
                                                       const Surroundings& around) {
  const std::optional<Name> old = named_at(text, cursor, around);
  if (!old) return std::unexpected("there is no name here");
  if (!is_renamable(*old))
    return std::unexpected(fmt::format("`{}` is not declared in this project", text::shown(old->text)));
  if (!is_name_in(text.language, name))
    return std::unexpected(fmt::format("`{}` is no name in this language", text::shown(name)));
  const Target target = *Targets().of(*old);
  const std::vector<Text> texts = all_texts(text, others);
  std::vector<Change> changes;
  for (const text::Place& place : places_of(target, texts, around)) {
    if (changes.empty() || changes.back().source != place.source) changes.push_back({place.source, {}});
    changes.back().splices.push_back({place.span, name});
  }
  const bool has_declaration = std::ranges::any_of(
      changes, [&](const Change& change) { return canonical_path(change.source->name()) == target.file; });
  if (!has_declaration)
    return std::unexpected(fmt::format("the file that declares `{}` is not at hand", text::shown(old->text)));
  if (name != old->text && !keeps_meaning(texts, changes, target, around))
    return std::unexpected(fmt::format("`{}` stands for something else already", text::shown(name)));
  return changes;
}

}  // namespace mlab::language
