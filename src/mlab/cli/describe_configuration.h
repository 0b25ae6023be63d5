#pragma once

#include <string>
#include <vector>

#include "mlab/cli/commands.h"

namespace mlab::cli {

/// Shows an assemblage, binding point, class or robot of the component library, by its own name (letter case
/// aside) or a historic one. False where there is none of that name.
bool describe_declaration(const DescribeOptions& options);
/// Shows what a configuration file declares.
int describe_configuration_file(const DescribeOptions& options);
/// One line for each declaration of the component library.
void list_declarations();
/// For "did you mean".
std::vector<std::string> declaration_names();

}  // namespace mlab::cli
