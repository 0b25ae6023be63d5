#include "mlab/lang/cdl/lower/findings.h"

#include <fmt/core.h>

namespace mlab::cdl {
namespace {

// What is unknown in several places is one slip, and so is what is wrong with one name.
std::string key_of(const std::string& kind, const Assemblage* inside, const text::Place& place,
                   const std::string& message, const std::string& about) {
  if (kind == "unknown-call" || kind == "unknown-type") return fmt::format("{} {}", kind, message);
  if (kind == "unknown-name" || !about.empty())
    return fmt::format("{} {} {} {} {}", kind, static_cast<const void*>(inside),
                       inside == nullptr ? static_cast<const void*>(place.source.get()) : nullptr, message,
                       about);
  return fmt::format("{} {} {} {}", kind, static_cast<const void*>(place.source.get()), place.span.begin,
                     message);
}

}  // namespace

text::Diagnostic& Findings::report(text::Severity severity, std::string kind, const text::Place& place,
                                   std::string message, const std::string& about) {
  if (!said_.keys.insert(key_of(kind, inside_, place, message, about)).second) return muted_ = {};
  return severity == text::Severity::kError ? sink_.error(std::move(kind), place, std::move(message))
                                            : sink_.warning(std::move(kind), place, std::move(message));
}

text::Diagnostic& Findings::error(std::string kind, const text::Place& place, std::string message) {
  return report(text::Severity::kError, std::move(kind), place, std::move(message));
}

text::Diagnostic& Findings::error_about(const std::string& about, std::string kind, const text::Place& place,
                                        std::string message) {
  return report(text::Severity::kError, std::move(kind), place, std::move(message), about);
}

text::Diagnostic& Findings::warning(std::string kind, const text::Place& place, std::string message) {
  return report(text::Severity::kWarning, std::move(kind), place, std::move(message));
}

void Findings::hint_nearest(text::Diagnostic& d, std::string_view name,
                            const std::vector<std::string>& candidates) {
  const std::string nearest = text::nearest_name(name, candidates);
  if (!nearest.empty()) d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
}

bool Findings::misses_name(const Assemblage& assemblage, const std::string& name) const {
  return said_.keys.contains(
      key_of("unknown-name", &assemblage, {}, fmt::format("unknown name `{}`", name), ""));
}

}  // namespace mlab::cdl
