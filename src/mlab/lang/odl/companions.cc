#include "mlab/lang/odl/companions.h"

#include <filesystem>

#include <fmt/core.h>

#include "mlab/lang/odl/map_info.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/overlay/picture.h"
#include "mlab/text/shown.h"

namespace mlab::odl {

namespace fs = std::filesystem;

std::optional<std::string> find_companion(std::string_view name, const std::string& near_path,
                                          const text::Files& files) {
  if (name.empty() || name.find('\0') != std::string_view::npos) return std::nullopt;
  for (const fs::path& folder : {fs::path(near_path).parent_path(), fs::path()}) {
    std::string candidate = (folder / fs::path(name)).lexically_normal().string();
    if (files.is_file(candidate)) return candidate;
  }
  return std::nullopt;
}

namespace {

text::Diagnostic& warn_missing(text::Diagnostics& sink, std::string kind, const text::Place& place,
                               std::string_view what, std::string_view name) {
  return sink.warning(std::move(kind), place,
                      fmt::format("there is no {} `{}`", what, text::shown(name, 200)));
}

void warn_unshown(text::Diagnostics& sink, const text::Place& place, std::string_view name,
                  std::string_view beginning) {
  const std::string why = overlay::why_not_shown(beginning);
  if (why.empty()) return;
  sink.warning("picture-format", place, fmt::format("`{}` {}", text::shown(name, 200), why)).label =
      "the background stays empty";
}

}  // namespace

void load_map(const std::string& name, const std::string& near_path, const text::Place& place,
              overlay::Overlay& into, text::Diagnostics& sink, const text::Files& files) {
  into.map_file = name;
  into.map_picture.reset();
  const std::optional<std::string> path = find_companion(name, near_path, files);
  if (!path) {
    warn_missing(sink, "missing-map", place, "map-info file", name).label = "the background stays empty";
    return;
  }
  into.map_file = *path;
  const text::Result<text::SourcePtr> source = files.read(*path);
  if (!source) {
    text::Diagnostic& d = sink.warning("missing-map", place, source.error().message);
    d.label = "the background stays empty";
    return;
  }
  const std::optional<MapInfo> info = parse_map_info(*source, sink);
  if (!info) return;
  const std::optional<std::string> picture = find_companion(info->picture, *path, files);
  if (!picture) warn_missing(sink, "missing-picture", place, "picture", info->picture);
  if (picture && files.beginning) warn_unshown(sink, place, info->picture, files.beginning(*picture));
  into.map_picture =
      overlay::MapPicture{picture.value_or(info->picture), {info->x, info->y}, info->width, info->height};
  if (info->sets_area) into.area = overlay::Area{info->width, info->height};
}

bool load_overlay(const std::string& path, overlay::Overlay& into, text::Diagnostics& sink,
                  const text::Files& files) {
  const std::size_t errors_before = sink.error_count();
  text::Result<text::SourcePtr> source = files.read(path);
  if (!source) {
    sink.report(std::move(source.error()));
    return false;
  }
  apply(parse(*source, sink), into, sink, Companions::kRead, files);
  return sink.error_count() == errors_before;
}

}  // namespace mlab::odl
