// Giving things other names, in all texts of a project.

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <fmt/core.h>

#include "mlab/assist/place_texts.h"
#include "mlab/assist/targets.h"
#include "mlab/base/counted.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cnl/lexer.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/lang/odl/token.h"
#include "mlab/text/shown.h"

namespace mlab::assist {
namespace {

constexpr std::size_t kLongestName = 200;

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

/// Where places of a text are after a change, and where they were before it.
std::uint32_t after(const std::vector<Splice>& splices, std::uint32_t at) {
  std::uint32_t out = at;
  for (const Splice& one : splices) {
    if (one.span.begin >= at) break;
    out += static_cast<std::uint32_t>(one.text.size()) - (one.span.end - one.span.begin);
  }
  return out;
}
std::vector<std::uint32_t> begins_after(const std::vector<Splice>& splices) {
  std::vector<std::uint32_t> out;
  std::uint32_t grown = 0;  // may wrap around
  for (const Splice& one : splices) {
    out.push_back(one.span.begin + grown);
    grown += static_cast<std::uint32_t>(one.text.size()) - (one.span.end - one.span.begin);
  }
  return out;
}
std::uint32_t before(const std::vector<Splice>& splices, std::uint32_t at, bool is_end) {
  std::uint32_t grown = 0;  // of which the difference counts, so that it may wrap around
  for (const Splice& one : splices) {
    const std::uint32_t begin = one.span.begin + grown;
    const auto size = static_cast<std::uint32_t>(one.text.size());
    if (at <= begin) break;
    if (at < begin + size || (is_end && at == begin + size)) return is_end ? one.span.end : one.span.begin;
    grown += size - (one.span.end - one.span.begin);
  }
  return at - grown;
}

/// One renaming, from the name to what has to hold once it is done.
class Renamer {
 public:
  Renamer(const Text& text, Name old, std::string to, const Surroundings& around)
      : text_(text),
        old_(std::move(old)),
        to_(std::move(to)),
        around_(around),
        target_(*Targets().of(old_)) {}

  std::expected<Renaming, Refusal> run() {
    out_.from = old_.text;
    out_.kind = name_of(old_.kind);
    texts_ = texts_with({old_.text, to_}, text_, around_);
    for (const Named& one : named_in(texts_, target_, around_)) add(one);
    if (const auto refusal = refused()) return std::unexpected(*refusal);
    if (to_ != old_.text) {
      if (const auto refusal = tried()) return std::unexpected(*refusal);
    }
    const auto is_declaring = [&](const Change& one) { return path_of(one.source) == target_.file; };
    std::ranges::stable_partition(out_.changes, is_declaring);
    add_notes();
    return std::move(out_);
  }

 private:
  static std::string path_of(const text::SourcePtr& source) { return canonical_path(source->name()); }

  void add(const Named& in) {
    Change change{in.text.source, {}};
    for (const Name& name : in.names) {
      if (name.kind == NameKind::kFile) continue;
      change.splices.push_back({name.span, name.is_unsaid ? "#" + to_ : to_});
    }
    if (change.splices.empty()) return;
    const std::string why = around_.fixed ? around_.fixed(in.text.source->name()) : "";
    if (why.empty()) {
      text::Diagnostics slips;
      if (!formatted(in.text, slips)) with_slips_.push_back(in.text.source);
      named_.push_back(in);
      out_.changes.push_back(std::move(change));
    } else {
      out_.kept.push_back({in.text.source, change.splices.size(), why});
    }
  }

  std::optional<Refusal> refused() const {
    const text::SourcePtr& declaring = old_.target.source;
    for (const Renaming::UnchangedFile& one : out_.kept) {
      if (path_of(one.source) == target_.file)
        return Refusal{fmt::format("`{}` is declared in `{}`, which {}", text::shown(old_.text),
                                   text::shown(one.source->name(), 200), one.why),
                       old_.target};
    }
    const bool has_declaration = std::ranges::any_of(
        out_.changes, [&](const Change& one) { return path_of(one.source) == target_.file; });
    if (!has_declaration)
      return Refusal{fmt::format("the file that declares `{}` is not at hand", text::shown(old_.text)), {}};
    const Language language = language_of(*declaring).value_or(text_.language);
    if (to_.size() > kLongestName)
      return Refusal{fmt::format("a name has at most {} letters", kLongestName), {}};
    for (const Named& one : named_) {
      // A place stands in a configuration as a text.
      const bool is_text = old_.kind == NameKind::kPlace && one.text.language == Language::kConfiguration;
      for (const Language in : {language, is_text ? language : one.text.language}) {
        if (!is_name_in(in, to_))
          return Refusal{fmt::format("`{}` is no name in this language", text::shown(to_)), {}};
      }
    }
    return of_other_maps();
  }

  // A robot that stands on two maps names the places of both by one text.
  std::optional<Refusal> of_other_maps() const {
    if (old_.kind != NameKind::kPlace) return std::nullopt;
    PlaceTexts place_texts(around_);
    Targets targets;
    for (const Named& one : named_) {
      for (const Name& other : place_texts.in(one.text)) {
        const bool is_changed = std::ranges::any_of(
            one.names, [&](const Name& name) { return name.span.begin == other.span.begin; });
        if (!is_changed || targets.of(other) == target_) continue;
        const text::Place at{one.text.source, other.span};
        return Refusal{fmt::format("`{}` is a place of `{}`, too", text::shown(other.text),
                                   text::shown(other.target.source->name(), 200)),
                       at};
      }
    }
    return std::nullopt;
  }

  const Change* change_of(const std::string& path) const {
    const auto found =
        std::ranges::find_if(out_.changes, [&](const Change& one) { return path_of(one.source) == path; });
    return found == out_.changes.end() ? nullptr : &*found;
  }

  /// A place of the changed texts as it stands now.
  text::Place place_now(const Text& changed, text::Span span) const {
    const Change* const change = change_of(path_of(changed.source));
    if (change == nullptr) return {changed.source, span};
    return {change->source,
            {before(change->splices, span.begin, false), before(change->splices, span.end, true)}};
  }

  /// Whether the new name means the same in the same places, and nothing else, and nothing becomes wrong.
  std::optional<Refusal> tried() {
    std::map<std::string, text::SourcePtr> changed;
    for (const Change& change : out_.changes)
      changed[path_of(change.source)] =
          std::make_shared<const text::Source>(change.source->name(), changed_text(change));
    Surroundings then = around_;
    const auto now = [&](Text one) {
      const auto found = changed.find(path_of(one.source));
      if (found != changed.end()) one.source = found->second;
      return one;
    };
    if (around_.project) {
      then.project = [&] {
        std::vector<Text> all = around_.project();
        std::ranges::transform(all, all.begin(), now);
        return all;
      };
    }
    then.checks_code = false;
    then.files.read = [&](const std::string& path) -> text::Result<text::SourcePtr> {
      const auto found = changed.find(canonical_path(path));
      return found == changed.end() ? around_.files.read(path) : found->second;
    };
    std::vector<Text> texts = texts_;
    std::ranges::transform(texts, texts.begin(), now);
    if (auto refusal = other_meaning(texts, then)) return refusal;
    return new_error(texts, then);
  }

  std::optional<Refusal> other_meaning(const std::vector<Text>& texts, const Surroundings& then) const {
    Target target = target_;
    if (const Change* change = change_of(target.file)) target.begin = after(change->splices, target.begin);
    std::set<std::pair<std::string, std::uint32_t>> expected;
    for (const Change& change : out_.changes) {
      const std::string path = path_of(change.source);
      for (const std::uint32_t begin : begins_after(change.splices)) expected.emplace(path, begin);
    }
    const auto taken = [&](const text::Place& place) {
      return Refusal{fmt::format("`{}` stands for something else already", text::shown(to_)), place};
    };
    for (const Named& one : named_in(texts, target, then)) {
      const std::string path = path_of(one.text.source);
      for (const Name& name : one.names) {
        // Behind the `#` that has come before it.
        const std::uint32_t begin = name.span.begin;
        const bool is_known =
            expected.erase({path, begin}) > 0 || (begin > 0 && expected.erase({path, begin - 1}) > 0);
        if (!is_known && name.kind != NameKind::kFile) return taken(place_now(one.text, name.span));
      }
    }
    if (expected.empty()) return std::nullopt;
    const Change* const lost = change_of(expected.begin()->first);
    const std::vector<std::uint32_t> begins = begins_after(lost->splices);
    const auto at = std::ranges::find(begins, expected.begin()->second);
    if (at == begins.end()) return taken({});
    return taken({lost->source, lost->splices[static_cast<std::size_t>(at - begins.begin())].span});
  }

  std::optional<Refusal> new_error(const std::vector<Text>& texts, const Surroundings& then) {
    Surroundings now = around_;
    now.checks_code = false;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (around_.given_up && around_.given_up()) return std::nullopt;
      const bool is_kept = std::ranges::any_of(
          out_.kept, [&](const Renaming::UnchangedFile& one) { return one.source == texts_[i].source; });
      if (is_kept) continue;
      const std::vector<text::Diagnostic> wrong = errors(texts[i], then);
      if (wrong.empty()) continue;
      const std::vector<text::Diagnostic> known = errors(texts_[i], now);
      // Where something is mended, what it hid comes to light: that was wrong before.
      const auto is_new = [&](const text::Diagnostic& one) {
        const bool is_about_it = known.empty() || one.message.contains("`" + to_ + "`");
        return is_about_it && std::ranges::none_of(known, [&](const text::Diagnostic& old) {
                 return old.kind == one.kind && old.place.source && one.place.source &&
                        old.place.source->line_column(old.place.span.begin).line ==
                            one.place.source->line_column(one.place.span.begin).line;
               });
      };
      const auto found = std::ranges::find_if(wrong, is_new);
      if (found == wrong.end()) continue;
      text::Place place;
      if (found->place.source) place = place_now({found->place.source, texts[i].language}, found->place.span);
      return Refusal{fmt::format("it would be wrong then: {}", found->message), place};
    }
    return std::nullopt;
  }

  static std::vector<text::Diagnostic> errors(const Text& text, const Surroundings& around) {
    std::vector<text::Diagnostic> out;
    const text::Diagnostics found = problems(text, around);
    for (const text::Diagnostic& one : found.items()) {
      if (one.severity == text::Severity::kError) out.push_back(one);
    }
    return out;
  }

  void add_notes() {
    for (const text::SourcePtr& one : with_slips_)
      out_.notes.push_back(fmt::format(
          "`{}` has slips of grammar: what stands in a part that can't be read keeps its name", one->name()));
    for (const Renaming::UnchangedFile& one : out_.kept)
      out_.notes.push_back(fmt::format("`{}` {}, and names it in {}: it will not know `{}` any more",
                                       one.source->name(), one.why, base::counted(one.places, "place"),
                                       old_.text));
    if (names_nodes())
      out_.notes.emplace_back(
          "the names of nodes follow from it, and random numbers from those: where what it stands for draws "
          "any, runs with the same seed come out differently");
  }

  // What is part of the paths by which random streams are keyed.
  bool names_nodes() const {
    switch (old_.kind) {
      case NameKind::kAssemblage:
      case NameKind::kProcedure:
      case NameKind::kNode:
      case NameKind::kLet:
      case NameKind::kState:
      case NameKind::kBinding:
      case NameKind::kDevice:
        return true;
      default:
        return false;
    }
  }

  const Text& text_;
  const Name old_;
  const std::string to_;
  const Surroundings& around_;
  const Target target_;
  std::vector<Text> texts_;
  std::vector<Named> named_;
  std::vector<text::SourcePtr> with_slips_;
  Renaming out_;
};

}  // namespace

std::string changed_text(const Change& change) {
  std::string out;
  std::uint32_t at = 0;
  for (const Splice& splice : change.splices) {
    out += change.source->text({at, splice.span.begin});
    out += splice.text;
    at = splice.span.end;
  }
  return out += change.source->text().substr(at);
}

std::expected<Renaming, Refusal> rename(const Text& text, std::uint32_t cursor, const std::string& name,
                                        const Surroundings& surroundings) {
  const Surroundings around = with_project_once(surroundings);
  std::optional<Name> old = named_at(text, cursor, around);
  if (!old) return std::unexpected(Refusal{"there is no name here", {}});
  if (!is_renamable(*old))
    return std::unexpected(
        Refusal{fmt::format("`{}` is not declared in this project", text::shown(old->text)), {}});
  return Renamer(text, std::move(*old), name, around).run();
}

}  // namespace mlab::assist
