#include "mlab/cli/shell_words.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>

#include "mlab/cli/files.h"

namespace mlab::cli {
namespace {

std::string on_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= 'a' && c <= 'z'; });
}

// CLI11 writes the names of validators behind the name of the type: `TEXT:{text,json}`, `N:INT in [1 - 256]`.
void read_type(const std::string& type, OptionWords& out) {
  out.value = type.substr(0, type.find(':'));
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open == std::string::npos ? 0 : open);
  if (open != std::string::npos && close != std::string::npos) {
    out.choices = split(std::string_view(type).substr(open + 1, close - open - 1), ',');
    return;
  }
  if (out.value.find('|') == std::string::npos) return;
  for (const std::string& word : split(out.value, '|')) {
    if (is_word(word)) out.choices.push_back(word);
  }
}

OptionWords option_words(const CLI::Option& option) {
  OptionWords out;
  if (option.get_positional()) {
    out.names = {option.get_name(true, false)};
  } else {
    for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  }
  out.help = on_one_line(option.get_description());
  out.group = option.get_group();
  out.initial = option.get_default_str();
  out.is_required = option.get_required();
  out.is_repeated = option.get_items_expected_max() > 1;
  if (option.get_items_expected_max() > 0) read_type(option.get_type_name(), out);
  return out;
}

CommandWords command_words(const CLI::App& app) {
  CommandWords out;
  out.name = app.get_name();
  out.help = on_one_line(app.get_description());
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    if (option->get_group().empty()) continue;
    (option->get_positional() ? out.positionals : out.options).push_back(option_words(*option));
  }
  return out;
}

}  // namespace

ProgramWords words_of(const CLI::App& app) {
  ProgramWords out;
  out.own = command_words(app);
  out.footer = app.get_footer();
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) out.commands.push_back(command_words(*command));
  }
  return out;
}

FileKind file_kind(const OptionWords& option) {
  if (!option.choices.empty()) return FileKind::kNone;
  if (option.value == "FOLDER") return FileKind::kFolder;
  return option.value.starts_with("FILE") || option.value.starts_with("MISSION") ? FileKind::kFile
                                                                                 : FileKind::kNone;
}

std::string file_ending(const OptionWords& option) {
  const std::size_t dot = option.value.find('.');
  return dot == std::string::npos ? "" : option.value.substr(dot + 1);
}

bool write_shell_files(const ProgramWords& program, const std::string& folder) {
  const auto write = [&](const std::string& file, const std::string& text) {
    const std::filesystem::path path = std::filesystem::path(folder) / file;
    std::error_code error;
    std::filesystem::create_directories(path.parent_path(), error);
    return write_file(path.string(), text);
  };
  // Debian's zsh looks in vendor-completions, zsh as it comes in site-functions.
  bool is_written = write("bash-completion/completions/mlab", bash_completion(program)) &&
                    write("zsh/vendor-completions/_mlab", zsh_completion(program)) &&
                    write("zsh/site-functions/_mlab", zsh_completion(program)) &&
                    write("fish/vendor_completions.d/mlab.fish", fish_completion(program)) &&
                    write("man/man1/mlab.1", manual_page(program));
  for (const CommandWords& command : program.commands) {
    is_written = is_written && write("man/man1/mlab-" + command.name + ".1", manual_page(program, command));
  }
  return is_written;
}

}  // namespace mlab::cli
