// What is wrong with a text.

#include <filesystem>

#include "mlab/assist/service.h"
#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cnl/format.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/network_file.h"
#include "mlab/run/crew.h"

namespace mlab::assist {
namespace {

std::string folder_of(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

// A mission is right when everything that a run needs can be made ready: overlays, programs, parameters,
// bodies.
void check_mission(const Text& text, const robot::ProgramSources& sources, const Surroundings& around,
                   text::Diagnostics& sink) {
  const auto mission =
      mdl::check_mission(text.source, sources.folder, sink,
                         {1, around.overlay_folders, around.files, robot::society_reader(sources)});
  if (mission) run::check_crew(mission, sources, sink);
}

}  // namespace

text::Diagnostics problems(const Text& text, const Surroundings& around) {
  text::Diagnostics sink;
  robot::ProgramSources sources = around.programs;
  sources.folder = folder_of(text.source->name());
  sources.files = &around.files;
  sources.checks_code = around.checks_code;
  switch (text.language) {
    case Language::kMission:
      if (sources.project.empty()) sources.project = sources.folder.empty() ? "." : sources.folder;
      check_mission(text, sources, around, sink);
      break;
    case Language::kOverlay: {
      overlay::Overlay overlay;
      const odl::Tree tree = odl::parse(text.source, sink);
      odl::apply(tree, overlay, sink, odl::Companions::kRead, around.files);
      break;
    }
    case Language::kNetwork:
      robot::check_network(text.source, sources, sink);
      break;
    case Language::kConfiguration:
      robot::check_configuration(text.source, sources, sink);
      break;
    case Language::kEnvironment:
      envchange::parse(text.source, {}, sink);
      break;
  }
  return sink;
}

std::optional<std::string> formatted(const Text& text, text::Diagnostics& sink) {
  switch (text.language) {
    case Language::kMission: {
      const mdl::Tree tree = mdl::parse(text.source, sink);
      return sink.has_errors() ? std::nullopt : std::optional(mdl::print(tree));
    }
    case Language::kOverlay: {
      const odl::Tree tree = odl::parse(text.source, sink);
      return sink.has_errors() ? std::nullopt : std::optional(odl::print(tree));
    }
    case Language::kNetwork:
      return cnl::format(text.source, sink);
    case Language::kConfiguration:
      if (text.source->name().ends_with(".formula") || cdl::looks_like_formula(text.source->text()))
        return std::string(text.source->text());  // a sentence has no layout of its own
      return cdl::format(text.source, sink);
    case Language::kEnvironment:
      return std::string(text.source->text());  // has no layout of its own
  }
  return std::nullopt;
}

}  // namespace mlab::assist
