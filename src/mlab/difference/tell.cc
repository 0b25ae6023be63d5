#include "mlab/difference/tell.h"

#include <algorithm>

#include <fmt/core.h>

namespace mlab::difference {
namespace {

constexpr std::size_t kLongest = 72;  // of what is quoted, in bytes

// On one line, not too long, and never cut inside of a letter.
std::string brief(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!is_blank)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  if (out.size() <= kLongest) return out;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0U) == 0x80U) --end;
  return out.substr(0, end) + "...";
}

// As a person reads it: what an active part stands beside is called `value` in paths.
std::string named(const std::string& name) {
  if (name.starts_with("value.")) return name.substr(6);
  return name.starts_with('$') ? name.substr(1) : name;
}

// `drift (Noise)`, `parameter speed`.
std::string called(const Difference& one, const std::string& raw) {
  const std::string name = brief(named(raw));
  switch (one.thing) {
    case Thing::kNode: {
      const std::string last = name.substr(name.rfind('.') + 1);
      const bool says_it = one.kind.empty() || last == one.kind || last.starts_with(one.kind + "_");
      return says_it ? name : fmt::format("{} ({})", name, one.kind);
    }
    case Thing::kTransition:
      return "transition from " + name;
    case Thing::kNote:
      return fmt::format("{} \"{}\"", one.kind, name);
    case Thing::kResult:
      return "result";
    case Thing::kUse:
    case Thing::kArchitecture:
    case Thing::kDeclaration:
    case Thing::kParameter:
    case Thing::kSetting:
    case Thing::kDevice:
    case Thing::kChoice:
    case Thing::kState:
      break;
  }
  return fmt::format("{} {}", one.kind, name);
}

std::string or_nothing(const std::string& text) {
  return text.empty() ? "nothing" : brief(named(text));
}

std::string details(const Difference& one) {
  std::string out;
  for (const Detail& detail : one.details) out += (out.empty() ? "" : "; ") + sentence(detail);
  return out;
}

}  // namespace

char sign_of(What what) {
  switch (what) {
    case What::kAdded:
      return '+';
    case What::kRemoved:
      return '-';
    case What::kMoved:
      return '>';
    case What::kChanged:
    case What::kRenamed:
      break;
  }
  return '~';
}

std::string_view word_of(What what) {
  switch (what) {
    case What::kAdded:
      return "added";
    case What::kRemoved:
      return "removed";
    case What::kRenamed:
      return "renamed";
    case What::kMoved:
      return "moved";
    case What::kChanged:
      break;
  }
  return "changed";
}

std::string_view word_of(Thing thing) {
  switch (thing) {
    case Thing::kUse:
      return "use";
    case Thing::kArchitecture:
      return "architecture";
    case Thing::kDeclaration:
      return "declaration";
    case Thing::kParameter:
      return "parameter";
    case Thing::kSetting:
      return "setting";
    case Thing::kDevice:
      return "device";
    case Thing::kChoice:
      return "choice";
    case Thing::kResult:
      return "result";
    case Thing::kState:
      return "state";
    case Thing::kTransition:
      return "transition";
    case Thing::kNote:
      return "note";
    case Thing::kNode:
      break;
  }
  return "node";
}

std::string place_of(const Difference& one) {
  return one.what == What::kRemoved && one.page_after.empty() ? one.page_before : one.page_after;
}

std::string sentence(const Detail& detail) {
  return fmt::format("{} {} -> {}", detail.what, or_nothing(detail.before), or_nothing(detail.after));
}

std::string sentence(const Difference& one) {
  if (one.what == What::kAdded || one.what == What::kRemoved) {
    const bool is_new = one.what == What::kAdded;
    std::string out = called(one, is_new ? one.name_after : one.name_before);
    if (one.thing != Thing::kTransition || one.details.empty()) return out;
    const Detail& words = one.details.front();
    return fmt::format("{}: {}", out, brief(is_new ? words.after : words.before));
  }
  if (one.what == What::kRenamed)
    return fmt::format("{} is now called {}", called(one, one.name_before), brief(named(one.name_after)));
  if (one.thing == Thing::kResult) return details(one);
  if (one.thing == Thing::kTransition)
    return fmt::format("{} to {}: {}", called(one, one.name_after), brief(one.kind), details(one));
  return fmt::format("{}: {}", called(one, one.name_after), details(one));
}

std::vector<std::string> remarks(const Comparison& comparison) {
  std::vector<std::string> out;
  if (comparison.is_same_text) return out;
  const std::size_t moved = comparison.layout.size();
  if (comparison.is_partial) {
    out.emplace_back(comparison.is_same() ? "only what could be read was compared, and that is the same"
                                          : "only what could be read was compared");
    return out;
  }
  if (!comparison.is_same()) {
    if (moved > 0) out.push_back(fmt::format("{} moved or noted on the canvas", moved));
    return out;
  }
  std::string differs;
  const auto add = [&](bool is_so, const std::string& what) {
    if (is_so) differs += (differs.empty() ? "" : ", ") + what;
  };
  add(comparison.is_written_otherwise, "the way it is written");
  add(comparison.has_other_layout,
      moved > 0 ? fmt::format("the layout ({} moved or noted)", moved) : std::string("the layout"));
  add(comparison.has_other_comments, "comments");
  out.push_back("both mean the same; what differs: " + (differs.empty() ? "blanks" : differs));
  return out;
}

}  // namespace mlab::difference
