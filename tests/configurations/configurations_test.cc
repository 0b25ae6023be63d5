// What configurations are to the checker, the compiler, the formatter and the designer, as it stands in
// digests.txt: a change of structure changes none of it, and a change of meaning shows where it is one.
//
// With MLAB_CONFIGURATIONS_OUT=FOLDER each aspect is written there as a file: run it before and after a
// change, and compare the folders. With MLAB_UPDATE_GOLDEN=1 what is seen is written into digests.txt.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "configurations.h"
#include "mlab/base/hash.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab {
namespace {

namespace fs = std::filesystem;

const fs::path kDigests = configurations::kSource / "tests/configurations/digests.txt";

// By the name of a configuration and of what of it is meant: `missions/rover/ranger.cdl: drawing Rover`.
using Aspects = std::map<std::string, std::string>;

std::string document_of(std::string_view source, std::string_view own) {
  return source == own ? "own" : "";
}

void add_drawings(const text::SourcePtr& source, const std::string& name, Aspects& out) {
  const designer::Model model(source, robot::library_environment());
  designer::Document declarations;
  designer::add_declarations(model, declarations);
  out[name + ": drawing of its declarations"] = declarations.DebugString();
  std::set<std::string> seen{""};
  std::vector<std::string> open{""};
  const designer::DrawingContext context{
      "own", 1, false, [&](std::string_view file) { return document_of(file, source->name()); }};
  while (!open.empty()) {
    const std::string path = open.back();
    open.pop_back();
    const designer::Drawing drawing = designer::draw(model, path, context);
    out[name + ": drawing " + path] = drawing.DebugString();
    const auto enter = [&](const designer::Page& page) {
      if (page.document() == "own" && seen.insert(page.path()).second) open.push_back(page.path());
    };
    for (const designer::Node& node : drawing.nodes()) enter(node.inner());
    for (const designer::State& state : drawing.states()) enter(state.inner());
  }
}

void add_networks(const text::SourcePtr& source, const std::string& name, Aspects& out) {
  text::Diagnostics sink;
  for (const cdl::Item& item : cdl::parse(source, sink).items) {
    const auto* one = std::get_if<cdl::Robot>(&item);
    if (one == nullptr) continue;
    text::Diagnostics said;
    const auto robot = robot::configure(source, one->name.text, "", {}, {}, said);
    out[name + ": network " + one->name.text] =
        robot ? cdl::cnl_text(robot->lowered.network) : text::render(said);
  }
}

void add_aspects(const text::SourcePtr& source, const std::string& name, Aspects& out) {
  text::Diagnostics sink;
  robot::check_configuration(source, {}, sink);
  out[name + ": problems"] = text::render(sink);
  text::Diagnostics ignored;
  out[name + ": text"] = cdl::format(source, ignored).value_or("can't be laid out\n");
  add_networks(source, name, out);
  add_drawings(source, name, out);
}

std::map<std::string, std::string> known_digests() {
  std::map<std::string, std::string> out;
  std::ifstream file(kDigests);
  for (std::string digest, rest; file >> digest && std::getline(file >> std::ws, rest);) out[rest] = digest;
  return out;
}

void write_out(const Aspects& aspects) {
  const char* folder = std::getenv("MLAB_CONFIGURATIONS_OUT");  // NOLINT(concurrency-mt-unsafe): as above
  if (folder == nullptr) return;
  for (const auto& [name, text] : aspects) {
    const fs::path path = fs::path(folder) / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
}

// One for all drawings of a configuration, and one for all its networks.
std::map<std::string, std::uint64_t> digests_of(const Aspects& aspects) {
  std::map<std::string, std::uint64_t> out;
  for (const auto& [name, text] : aspects) {
    std::uint64_t& digest = out[name.substr(0, name.find(' ', name.find(": ") + 2))];
    digest = base::combine_bits(digest, base::hash_text(name + "\n" + text));
  }
  return out;
}

// Of the digests those whose names `is_meant`.
void compare(const Aspects& aspects, const std::function<bool(std::string_view)>& is_meant) {
  write_out(aspects);
  std::map<std::string, std::string> known = known_digests();
  std::map<std::string, std::string> here;
  std::erase_if(known, [&](const auto& one) {
    const bool is_here = is_meant(one.first);
    if (is_here) here.insert(one);
    return is_here;
  });
  std::map<std::string, std::string> seen;
  for (const auto& [name, digest] : digests_of(aspects)) seen[name] = fmt::format("{:016x}", digest);
  if (std::getenv("MLAB_UPDATE_GOLDEN") != nullptr) {  // NOLINT(concurrency-mt-unsafe): as above
    known.insert(seen.begin(), seen.end());
    std::ofstream file(kDigests);
    for (const auto& [name, digest] : known) file << digest << " " << name << "\n";
    return;
  }
  EXPECT_FALSE(seen.empty());
  std::set<std::string> names;
  for (const auto* some : {&here, &seen}) {
    for (const auto& [name, digest] : *some) names.insert(name);
  }
  for (const std::string& name : names)
    EXPECT_EQ(seen[name], here[name]) << name << " (MLAB_CONFIGURATIONS_OUT=FOLDER shows it)";
}

void add_imported(const fs::path& folder, const std::string& name, Aspects& out) {
  configurations::for_each_imported(
      folder, name,
      [&](const text::SourcePtr& source, const std::string& imported) { add_aspects(source, imported, out); },
      [&](const std::string& imported, const std::string& text) {
        out[imported + ": text as imported"] = text;
      });
}

TEST(Configurations, OfTheProjectAreWhatTheyWere) {
  Aspects aspects;
  configurations::for_each_own(
      [&](const text::SourcePtr& source, const std::string& name) { add_aspects(source, name, aspects); });
  add_imported(configurations::kSource / "src/mlab/lang/cdl_historic/testdata", "imported", aspects);
  compare(aspects, [](std::string_view name) { return !name.starts_with("corpus/"); });
}

TEST(Configurations, OfTheCorpusAreWhatTheyWere) {
  if (!configurations::has_corpus()) GTEST_SKIP() << "no corpus at " << configurations::corpus();
  Aspects aspects;
  add_imported(configurations::corpus(), "corpus", aspects);
  compare(aspects, [](std::string_view name) { return name.starts_with("corpus/"); });
}

}  // namespace
}  // namespace mlab
