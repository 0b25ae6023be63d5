#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/cli/commands.h"

namespace mlab::cli {

/// Shows an assemblage, binding point, class or robot of the component library, by its own name (letter case
/// and underscores aside) or a historic one.
/// @return its name; empty where there is none
std::string describe_declaration(const DescribeOptions& options);
/// A line for each name under which a component stood in the historic libraries.
void print_historic_names(std::string_view ours);
/// Shows what a configuration file declares.
int describe_configuration_file(const DescribeOptions& options);
/// One line for each declaration of the component library.
void list_declarations();
/// The first sentence of an explanation, or its first line where that ends earlier.
std::string first_sentence(std::string_view help);
/// For "did you mean".
std::vector<std::string> declaration_names();

}  // namespace mlab::cli
