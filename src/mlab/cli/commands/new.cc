// `mlab new`: a small mission, behavior or configuration to begin with, which runs as it is.

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/assist/service.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/describe_configuration.h"
#include "mlab/cli/files.h"
#include "mlab/cli/new_templates.h"
#include "mlab/cli/terminal.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLetters = 60;

struct Fresh {
  std::string ending;
  const char* text;
};

// What there is to begin with, and what the mission that tries it out sets of it.
struct Beginning {
  const char* kind;
  std::vector<Fresh> files;
  const char* setting;
};

const std::vector<Beginning>& beginnings() {
  static const std::vector<Beginning> kAll = {
      {"mission", {{"mdl", kMissionTemplate}, {"odl", kMapTemplate}}, ""},
      {"behavior", {{"cnl", kBehaviorTemplate}, {"mdl", kTrialTemplate}, {"odl", kMapTemplate}}, "speed = 2"},
      {"configuration",
       {{"cdl", kConfigurationTemplate}, {"mdl", kTrialTemplate}, {"odl", kMapTemplate}},
       "success_radius = 3"}};
  return kAll;
}

int refuse_new(const std::string& why) {
  fmt::print(stderr, "mlab new: {}\n", why);
  return kBadInput;
}

bool is_plain_name(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= kMostLetters && is_letter(name.front()) &&
         std::ranges::all_of(
             name, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; });
}

// `keep_left` is `KeepLeft`.
std::string type_name(const std::string& name) {
  std::string out;
  bool begins = true;
  for (const char c : name) {
    if (c == '_' || c == '-') {
      begins = true;
      continue;
    }
    out += std::exchange(begins, false) ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
  }
  return out;
}

bool is_in_library(const std::string& type) {
  const std::vector<std::string> declared = declaration_names();
  return robot::component_library().find(type).behavior != nullptr ||
         std::ranges::find(declared, type) != declared.end();
}

std::string filled_in(std::string text, const std::vector<std::pair<std::string, std::string>>& words) {
  for (const auto& [word, meaning] : words) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += meaning.size())
      text.replace(at, word.size(), meaning);
  }
  return text;
}

// The text in its canonical layout, which depends on the length of the names in it.
std::string tidy(const fs::path& path, std::string text) {
  const auto source = std::make_shared<const text::Source>(path.string(), std::move(text));
  text::Diagnostics sink;
  const std::optional<assist::Language> language = assist::language_of(*source);
  const auto out = language ? assist::formatted({source, *language}, sink) : std::nullopt;
  tell(sink);
  return out.value_or(std::string(source->text()));
}

}  // namespace

std::vector<std::string> new_kinds() {
  std::vector<std::string> out;
  for (const Beginning& one : beginnings()) out.emplace_back(one.kind);
  return out;
}

int make_new(const NewOptions& options) {
  const fs::path path(options.name);
  const std::string name = path.filename().string();
  if (!is_plain_name(name))
    return refuse_new(
        fmt::format("`{}`: expected a name of letters, digits, `_` and `-`, with a letter first", name));
  const std::string type = type_name(name);
  if (options.kind != "mission" && is_in_library(type))
    return refuse_new(fmt::format("the component library has a `{}` already; choose another name", type));
  const Beginning& beginning = *std::ranges::find(beginnings(), options.kind, &Beginning::kind);
  std::vector<fs::path> files;
  for (const Fresh& fresh : beginning.files) {
    files.emplace_back(path.string() + "." + fresh.ending);
    std::error_code error;
    if (fs::exists(fs::symlink_status(files.back(), error)))
      return refuse_new(fmt::format("{} is there already; nothing was written", files.back().string()));
  }
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string text = filled_in(beginning.files[i].text, {{"@NAME@", name},
                                                                 {"@FILE@", name},
                                                                 {"@TYPE@", type},
                                                                 {"@ENDING@", beginning.files.front().ending},
                                                                 {"@SETTING@", beginning.setting}});
    if (!write_file(files[i].string(), tidy(files[i], text)))
      return refuse_new(fmt::format("{} can't be written{}", files[i].string(), why_not_written()));
    fmt::print("{}\n", files[i].string());
  }
  fmt::print(
      "\nmlab run {0}.mdl             opens it in the console\nmlab run {0}.mdl --headless  runs it in the "
      "terminal\n",
      path.string());
  if (options.kind == "configuration") fmt::print("mlab edit {}.cdl            draws it\n", path.string());
  return kDone;
}

}  // namespace mlab::cli
