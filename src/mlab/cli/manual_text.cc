// Manual pages in roff.

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/cli/shell_words.h"
#include "mlab/cli/version.h"

namespace mlab::cli {
namespace {

// So that roff shows what stands there: no escapes, no requests, a hyphen that can be copied.
std::string roff(std::string_view text) {
  std::string out;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) out += "\\&";
    begins_line = c == '\n';
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string shown_value(const OptionWords& option) {
  return option.choices.empty() || option.value.find('|') != std::string::npos
             ? option.value
             : fmt::format("{}", fmt::join(option.choices, "|"));
}

std::string option_entry(const OptionWords& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back("\\fB" + roff(name) + "\\fR");
  std::string out = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (!option.value.empty()) out += " \\fI" + roff(shown_value(option)) + "\\fR";
  out += "\n" + roff(option.help);
  if (!option.initial.empty()) out += roff(fmt::format(" (default: {})", option.initial));
  return out + "\n";
}

std::string argument_entry(const OptionWords& option) {
  return fmt::format(".TP\n\\fI{}\\fR\n{}\n", roff(shown_value(option)), roff(option.help));
}

std::string options_section(const std::vector<OptionWords>& options) {
  std::vector<std::string> groups;
  for (const OptionWords& option : options) {
    if (std::ranges::find(groups, option.group) == groups.end()) groups.push_back(option.group);
  }
  std::string out;
  for (const std::string& group : groups) {
    std::string title = group;
    for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    out += fmt::format(".SH {}\n", roff(title));
    for (const OptionWords& option : options) {
      if (option.group == group) out += option_entry(option);
    }
  }
  return out;
}

std::string head(const std::string& page, const std::string& what) {
  std::string title = page;
  for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return fmt::format(".TH {} 1 \"\" \"missionlab {}\" \"missionlab\"\n.SH NAME\n{} \\- {}\n", roff(title),
                     kVersion, roff(page), roff(what));
}

std::string footer_section(const ProgramWords& program) {
  const std::string_view label = "Exit status: ";
  std::string text = program.footer.substr(0, program.footer.find('\n'));
  if (text.starts_with(label)) text.erase(0, label.size());
  return fmt::format(".SH EXIT STATUS\n{}\n", roff(text));
}

// The first sentence, without its full stop.
std::string short_help(const std::string& help) {
  return help.substr(0, std::min({help.find(". "), help.find_last_not_of('.') + 1}));
}

}  // namespace

std::string manual_page(const ProgramWords& program) {
  std::string out = head("mlab", short_help(program.own.help));
  out += ".SH SYNOPSIS\n\\fBmlab\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n.SH COMMANDS\n";
  for (const CommandWords& command : program.commands)
    out += fmt::format(".TP\n\\fBmlab\\-{}\\fR(1)\n{}\n", roff(command.name), roff(command.help));
  out += options_section(program.own.options) + footer_section(program);
  return out +
         ".SH FILES\nDocumentation, examples, missions and the component library are in "
         "\\fI/usr/share/mlab\\fR.\n";
}

std::string manual_page(const ProgramWords& program, const CommandWords& command) {
  std::string out = head("mlab-" + command.name, short_help(command.help));
  out += fmt::format(".SH SYNOPSIS\n\\fBmlab {}\\fR [\\fIOPTIONS\\fR]", roff(command.name));
  for (const OptionWords& one : command.positionals) {
    const std::string value = "\\fI" + roff(shown_value(one)) + "\\fR" + (one.is_repeated ? " ..." : "");
    out += one.is_required ? " " + value : " [" + value + "]";
  }
  out += fmt::format("\n.SH DESCRIPTION\n{}\n", roff(command.help));
  for (const OptionWords& one : command.positionals) out += argument_entry(one);
  out += options_section(command.options) + footer_section(program);
  return out + ".SH SEE ALSO\n\\fBmlab\\fR(1)\n";
}

}  // namespace mlab::cli
