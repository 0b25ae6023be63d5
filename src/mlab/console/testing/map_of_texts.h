#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mlab/console/documents/overlay_edit.h"
#include "mlab/console/published/scene_encoder.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::console::testing {

/// A mission and overlays that stand on no disk, for tests and fuzzers of edits of the map.
class MapOfTexts {
 public:
  MapOfTexts(std::string mission, std::map<std::string, std::string> overlays)
      : overlays_(std::move(overlays)) {
    mission_ = std::move(mission);
    read();
  }
  /// One overlay, `o.odl`, named by a mission of one step.
  explicit MapOfTexts(std::string overlay)
      : MapOfTexts("OVERLAY o.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n 0. QUIT\n",
                   {{"o.odl", std::move(overlay)}}) {}

  const std::string& mission() const { return mission_; }
  const std::string& overlay(const std::string& name = "o.odl") const { return overlays_.at(name); }
  const overlay::Overlay& map() const { return map_; }
  bool has_errors() const { return has_errors_; }
  const std::string& said() const { return said_; }

  text::Result<std::vector<TextEdit>> edits(const google::protobuf::RepeatedPtrField<MapChange>& changes,
                                            const std::string& target = "") const {
    return edit_map(texts(), changes, target);
  }
  /// Does the changes. @return why it could not; empty: it did
  std::string change(const std::vector<MapChange>& changes, const std::string& target = "") {
    const google::protobuf::RepeatedPtrField<MapChange> list(changes.begin(), changes.end());
    return take(edits(list, target));
  }
  std::string create(const CreateObstacles& request, std::uint32_t seed) {
    bool is_complete = true;
    return take(create_obstacles(texts(), request, seed, is_complete));
  }

  Scene scene() const {
    return encode_scene(map_, [](const text::Place& place) {
      if (!place.source) return DocumentPlace{};
      return DocumentPlace{place.source->name(), place.source->line_column(place.span.begin).line};
    });
  }

 private:
  std::string take(const text::Result<std::vector<TextEdit>>& made) {
    if (!made) return made.error().message;
    for (const TextEdit& edit : *made) {
      std::string& text = edit.source->name() == "m.mdl" ? mission_ : overlays_.at(edit.source->name());
      text = text::spliced(text, edit.splice);
    }
    read();
    return "";
  }

  void read() {
    sources_.clear();
    mission_source_ = std::make_shared<const text::Source>("m.mdl", mission_);
    for (const auto& [name, text] : overlays_)
      sources_[name] = std::make_shared<const text::Source>(name, text);
    mdl::LoadOptions options;
    options.seed = 1;
    options.files = {
        [this](const std::string& path) { return sources_.contains(path); },
        [this](const std::string& path) -> text::Result<text::SourcePtr> { return sources_.at(path); },
        {}};
    text::Diagnostics sink;
    map_ = mdl::check_map(mission_source_, "", sink, options);
    text::Diagnostics all;
    has_errors_ = mdl::check_mission(mission_source_, "", all, options) == nullptr;
    said_ = text::render(all);
  }

  MapTexts texts() const {
    MapTexts out{mission_source_, {}, {}, &map_};
    text::Diagnostics unsaid;
    for (const mdl::Statement& statement : mdl::parse(mission_source_, unsaid).preamble) {
      const auto* named = std::get_if<mdl::statement::OverlayFile>(&statement.what);
      if (named == nullptr) continue;
      const auto found = sources_.find(named->file.text);
      if (found == sources_.end()) {
        out.order.push_back(MapTexts::kMissing);
        continue;
      }
      const auto known = std::ranges::find(out.overlays, found->first, &MapTexts::OverlayText::path);
      out.order.push_back(static_cast<std::uint32_t>(known - out.overlays.begin()));
      if (known == out.overlays.end()) out.overlays.push_back({found->first, found->second});
    }
    return out;
  }

  std::string mission_;
  std::map<std::string, std::string> overlays_;
  text::SourcePtr mission_source_;
  std::map<std::string, text::SourcePtr> sources_;
  overlay::Overlay map_;
  bool has_errors_ = false;
  std::string said_;
};

}  // namespace mlab::console::testing
