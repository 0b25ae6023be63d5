// Completion for bash, zsh and fish.

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/cli/shell_words.h"

namespace mlab::cli {
namespace {

constexpr const char* kOrigin = "made by `mlab completion {}` from the definitions of the options";

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

// Between single quotes of bash and zsh; of fish, which knows `\'`.
std::string quoted(const std::string& text) {
  return "'" + replaced(text, "'", "'\\''") + "'";
}
std::string fish_quoted(const std::string& text) {
  return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

std::vector<std::string> command_names(const ProgramWords& program) {
  std::vector<std::string> out;
  for (const CommandWords& command : program.commands) out.push_back(command.name);
  return out;
}

std::vector<std::string> option_names(const CommandWords& command) {
  std::vector<std::string> out;
  for (const OptionWords& option : command.options)
    out.insert(out.end(), option.names.begin(), option.names.end());
  return out;
}

// ------------------------------------------------------------------------------------------------------ bash

std::string bash_values(const OptionWords& option) {
  if (!option.choices.empty())
    return fmt::format("_mlab_words {}", quoted(fmt::format("{}", fmt::join(option.choices, " "))));
  if (file_kind(option) == FileKind::kFolder) return "_mlab_folders";
  if (file_kind(option) == FileKind::kFile) return fmt::format("_mlab_files {}", quoted(file_ending(option)));
  return ":";
}

std::string bash_command(const CommandWords& command) {
  std::string out;
  for (const OptionWords& option : command.options) {
    if (option.value.empty()) continue;
    std::string pattern;
    for (const std::string& name : option.names)
      pattern += fmt::format("{}'{} {}'", pattern.empty() ? "" : " | ", command.name, name);
    out += fmt::format("    {}) {}; return ;;\n", pattern, bash_values(option));
  }
  return out;
}

// Which argument that is no option stands there, counted from 0.
std::string bash_positionals(const CommandWords& command) {
  std::string out;
  for (std::size_t i = 0; i < command.positionals.size(); ++i) {
    const OptionWords& one = command.positionals[i];
    out += fmt::format("    '{} {}'{}) {} ;;\n", command.name, one.is_repeated ? "" : fmt::format("{}", i),
                       one.is_repeated ? "*" : "", bash_values(one));
  }
  return out;
}

// ------------------------------------------------------------------------------------------------------- zsh

std::string zsh_help(const std::string& text) {
  std::string out = text;
  for (const char* special : {"\\", "[", "]", ":"}) out = replaced(out, special, std::string("\\") + special);
  return replaced(out, "'", "'\\''");
}

std::string zsh_values(const OptionWords& option) {
  if (!option.choices.empty()) return fmt::format("({})", fmt::join(option.choices, " "));
  if (file_kind(option) == FileKind::kFolder) return "_files -/";
  if (file_kind(option) == FileKind::kNone) return " ";
  const std::string ending = file_ending(option);
  return ending.empty() ? "_files" : fmt::format("_files -g \"*.{}\"", ending);
}

std::string zsh_option(const OptionWords& option) {
  const std::string value =
      option.value.empty() ? "" : fmt::format(":{}:{}", zsh_help(option.value), zsh_values(option));
  const std::string rest = fmt::format("'[{}]{}'", zsh_help(option.help), value);
  if (option.names.size() == 1) return option.names.front() + rest;
  return fmt::format("'({})'{{{}}}{}", fmt::join(option.names, " "), fmt::join(option.names, ","), rest);
}

std::string zsh_arguments(const CommandWords& command) {
  std::string out = "_arguments -S";
  for (const OptionWords& option : command.options) out += " \\\n        " + zsh_option(option);
  for (std::size_t i = 0; i < command.positionals.size(); ++i) {
    const OptionWords& one = command.positionals[i];
    out += fmt::format(" \\\n        '{}:{}:{}'", one.is_repeated ? "*" : fmt::format("{}", i + 1),
                       zsh_help(one.value.empty() ? one.names.front() : one.value), zsh_values(one));
  }
  return out;
}

// ------------------------------------------------------------------------------------------------------ fish

std::string fish_values(const OptionWords& option) {
  if (!option.choices.empty())
    return " -x -a " + fish_quoted(fmt::format("{}", fmt::join(option.choices, " ")));
  if (file_kind(option) == FileKind::kFolder) return " -x -a '(__fish_complete_directories)'";
  if (file_kind(option) == FileKind::kNone) return " -x";
  const std::string ending = file_ending(option);
  return ending.empty() ? " -r -F" : fmt::format(" -x -a '(__fish_complete_suffix .{})'", ending);
}

std::string fish_option(const OptionWords& option, const std::string& condition) {
  std::string out = fmt::format("complete -c mlab -n {}", fish_quoted(condition));
  for (const std::string& name : option.names)
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) out += fish_values(option);
  return out + " -d " + fish_quoted(option.help) + "\n";
}

std::string fish_positional(const OptionWords& option, const std::string& condition) {
  const std::string values = fish_values(option);
  if (values == " -x") return "";
  return fmt::format("complete -c mlab -n {}{}\n", fish_quoted(condition),
                     values == " -r -F" ? " -F" : replaced(values, " -x", ""));
}

}  // namespace

std::string bash_completion(const ProgramWords& program) {
  std::string values;
  std::string options = fmt::format("      '') _mlab_words {} ;;\n",
                                    quoted(fmt::format("{}", fmt::join(option_names(program.own), " "))));
  std::string positionals;
  for (const CommandWords& command : program.commands) {
    values += bash_command(command);
    options += fmt::format("      {}) _mlab_words {} ;;\n", command.name,
                           quoted(fmt::format("{}", fmt::join(option_names(command), " "))));
    positionals += bash_positionals(command);
  }
  return fmt::format(R"(# Completion of mlab for bash; {}.
_mlab_words() {{ mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current"); }}
_mlab_folders() {{ mapfile -t COMPREPLY < <(compgen -d -- "$current"); }}
_mlab_files() {{
  mapfile -t COMPREPLY < <(if [[ -n $1 ]]; then compgen -f -X "!*.$1" -- "$current"; compgen -d -- "$current"
    else compgen -f -- "$current"; fi)
}}
_mlab() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} command= arguments=0 i
  COMPREPLY=()
  if [[ $current == = ]]; then current=; elif [[ $previous == = ]]; then previous=${{COMP_WORDS[COMP_CWORD - 2]}}; fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    [[ ${{COMP_WORDS[i]}} != -* ]] || continue
    if [[ -z $command ]]; then command=${{COMP_WORDS[i]}}; else arguments=$((arguments + 1)); fi
  done
  case "$command $previous" in
{}  esac
  if [[ $current == -* ]]; then
    case $command in
{}    esac
    return
  fi
  case "$command $arguments" in
    ' 0') _mlab_words {} ;;
{}  esac
}}
complete -o filenames -F _mlab mlab
)",
                     fmt::format(fmt::runtime(kOrigin), "bash"), values, options,
                     quoted(fmt::format("{}", fmt::join(command_names(program), " "))), positionals);
}

std::string zsh_completion(const ProgramWords& program) {
  std::string commands;
  std::string cases;
  for (const CommandWords& command : program.commands) {
    commands += fmt::format("\n        '{}:{}'", command.name, zsh_help(command.help));
    cases += fmt::format("      {})\n        {} ;;\n", command.name, zsh_arguments(command));
  }
  std::string own;
  for (const OptionWords& option : program.own.options) own += " \\\n    " + zsh_option(option);
  return fmt::format(R"(#compdef mlab
# Completion of mlab for zsh; {}.
_mlab() {{
  local state line
  _arguments -C{} \
    '1:command:->command' '*::argument:->argument'
  case $state in
    command)
      local -a commands=({})
      _describe command commands ;;
    argument)
      case $line[1] in
{}      esac ;;
  esac
}}
if [[ $funcstack[1] == _mlab ]]; then _mlab "$@"; else compdef _mlab mlab; fi
)",
                     fmt::format(fmt::runtime(kOrigin), "zsh"), own, commands, cases);
}

std::string fish_completion(const ProgramWords& program) {
  std::string out = fmt::format("# Completion of mlab for fish; {}.\ncomplete -c mlab -f\n",
                                fmt::format(fmt::runtime(kOrigin), "fish"));
  for (const OptionWords& option : program.own.options) out += fish_option(option, "__fish_use_subcommand");
  for (const CommandWords& command : program.commands) {
    out += fmt::format("complete -c mlab -n __fish_use_subcommand -a {} -d {}\n", command.name,
                       fish_quoted(command.help));
    const std::string condition = "__fish_seen_subcommand_from " + command.name;
    for (const OptionWords& option : command.options) out += fish_option(option, condition);
    for (const OptionWords& one : command.positionals) out += fish_positional(one, condition);
  }
  return out;
}

}  // namespace mlab::cli
