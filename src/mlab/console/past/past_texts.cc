#include "mlab/console/past/past_texts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "mlab/console/published/overview.h"
#include "mlab/text/line_ends.h"
#include "mlab/text/utf8.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;

// Texts that programs are made from.
bool is_of_program(const std::string& path) {
  constexpr std::array<std::string_view, 5> kEndings = {".cdl", ".cnl", ".cc", ".h", ".toml"};
  return std::ranges::any_of(kEndings, [&](std::string_view ending) { return path.ends_with(ending); });
}

std::string name_in(const std::string& folder, const std::string& path) {
  const std::string relative = fs::path(path).lexically_relative(folder).generic_string();
  const bool is_inside = !relative.empty() && relative != "." && !relative.starts_with("..");
  return clean(is_inside ? relative : fs::path(path).filename().string());
}

}  // namespace

PastTexts::PastTexts(const history::History& history, const wire::HistoryMission& version,
                     std::uint64_t number) {
  for (const std::uint32_t id : version.texts()) {
    const text::SourcePtr text = history.text(id);
    const bool is_mission = text->name() == version.path();
    if (!is_mission && is_of_program(text->name())) continue;
    const std::string name = name_in(version.folder(), text->name());
    if (!names_.emplace(text->name(), name).second) continue;
    Documents::Document document;
    document.set_path(name);
    document.set_language(is_mission ? Complete::MISSION : Complete::OVERLAY);
    document.set_text(text::unix_lines(text::as_utf8(text->text())));
    document.set_revision(number);
    document.set_is_read_only(true);
    *message_.add_documents() = std::move(document);
    const int last = message_.documents_size() - 1;
    if (is_mission && last > 0) message_.mutable_documents()->SwapElements(0, last);
  }
}

DocumentPlace PastTexts::place(const text::Place& place) const {
  if (!place.source) return {};
  const auto found = names_.find(place.source->name());
  if (found == names_.end()) return {};
  return {found->second, place.source->line_column(place.span.begin).line};
}

}  // namespace mlab::console
