#include "mlab/cli/wrong_words.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "mlab/text/diagnostic.h"

namespace mlab::cli {
namespace {

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = text::nearest_name(word, known);
  return nearest.empty() ? "" : fmt::format("; did you mean `{}`?", nearest);
}

// The command that was to be carried out; the program itself where none was.
const CLI::App& command_of(const CLI::App& app) {
  const std::vector<CLI::App*> told = app.get_subcommands();
  return told.empty() ? app : *told.front();
}

std::optional<std::string> unknown_option(const CLI::App& command, const std::vector<std::string>& words) {
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  }
  for (const std::string& all : words) {
    if (all == "--") break;
    const std::string word = all.substr(0, all.find('='));
    if (!word.starts_with("--") || std::ranges::find(known, word) != known.end()) continue;
    return fmt::format("there is no option `{}`{}", word, did_you_mean(word, known));
  }
  return std::nullopt;
}

std::string what_is_missing(const CLI::App& command, const CLI::ParseError& error) {
  for (const CLI::Option* one : command.get_options()) {
    if (one->get_positional() && one->get_required() && one->count() == 0)
      return fmt::format("{} is missing: {}", one->get_type_name(), one->get_description());
  }
  const bool is_program = command.get_parent() == nullptr;
  return is_program ? "a command is missing; the first to try: mlab run MISSION.mdl" : error.what();
}

std::string what_is_too_much(const CLI::App& app) {
  std::string all;
  for (const std::string& word : app.remaining(true)) {
    // One of the command's own was put in front of it: others have been told of before.
    if (word.starts_with("--"))
      return fmt::format("expected `{}` behind the command, not in front of it", word);
    if (word.starts_with('-') && word.size() > 1) return fmt::format("there is no option `{}`", word);
    all += fmt::format("{}`{}`", all.empty() ? "" : ", ", word);
  }
  return fmt::format("there is no place for {}", all);
}

// The library's words begin with the option that they are about.
std::string what_is_expected(const CLI::App& command, const CLI::ParseError& error) {
  static constexpr std::string_view kNoNumber = "Could not convert: ";
  std::string told = error.what();
  const bool is_no_number = told.starts_with(kNoNumber);
  if (is_no_number) told.erase(0, kNoNumber.size());
  const std::string name = told.substr(0, told.find_first_of(" :"));
  const CLI::Option* const option = command.get_option_no_throw(name);
  if (option == nullptr) return error.what();
  const std::string value = option->get_type_name();
  if (is_no_number) {
    const std::size_t given = std::min(told.find("= "), told.size() - 2) + 2;
    return fmt::format("{}: expected a number ({}), found `{}`", name, value, told.substr(given));
  }
  if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ArgumentMismatch)) return told;
  const auto most = static_cast<std::size_t>(std::max(option->get_items_expected_max(), 0));
  const std::size_t given = option->results().size();
  if (most > 0 && given > most && given % most == 0)
    return fmt::format("{} is given twice: expected it once", name);
  return option->get_items_expected_max() == 0 ? fmt::format("{} takes no value", name)
                                               : fmt::format("{}: expected {} behind it", name, value);
}

std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error,
                          const std::vector<std::string>& words) {
  const CLI::App& command = command_of(app);
  if (auto unknown = unknown_option(command, words)) return *unknown;
  switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
    case CLI::ExitCodes::RequiredError:
      return what_is_missing(command, error);
    case CLI::ExitCodes::ExtrasError:
      return what_is_too_much(app);
    default:
      return what_is_expected(command, error);
  }
}

}  // namespace

void tell_wrong_words(const CLI::App& app, const CLI::ParseError& error,
                      const std::vector<std::string>& words) {
  const CLI::App& command = command_of(app);
  const bool is_program = &command == &app;
  fmt::print(stderr, "{}{}{}: {}\nRun with --help for all of them.\n", app.get_name(), is_program ? "" : " ",
             is_program ? "" : command.get_name(), what_is_wrong(app, error, words));
}

bool is_unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) return false;
  return app.get_subcommands([&](const CLI::App* one) { return one->check_name(words.front()); }).empty();
}

void tell_unknown_command(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> known;
  for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!one->get_group().empty()) known.push_back(one->get_name());
  }
  fmt::print(stderr, "{}: there is no command `{}`{}\nRun {} --help for all of them.\n", app.get_name(),
             words.front(), did_you_mean(words.front(), known), app.get_name());
}

}  // namespace mlab::cli
