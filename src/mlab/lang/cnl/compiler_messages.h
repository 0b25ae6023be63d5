#pragma once

#include <string_view>

#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cnl {

/// Turns what g++ printed (without carets, columns in bytes) into diagnostics at the author's places. A
/// message about another file, or about the generated text, is put where the author's code led there.
///
/// @return  how many errors there were
std::size_t report_compiler_messages(std::string_view output, const Tree& tree,
                                     text::Diagnostics& diagnostics);

}  // namespace mlab::cnl
