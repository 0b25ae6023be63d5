#pragma once

#include <string>
#include <string_view>

#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/lang/cdl_historic/vocabulary.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl_historic {

/// Reads a historic configuration and says it in our language.
///
/// What was dynamic is resolved: pushed-up parameters become arguments, list elements are paired by position,
/// parts that several others read become a `let`. Library names become ours; what has no counterpart becomes
/// an empty assemblage, declared with the parameters it was used with. The drawing keeps its relative order.
///
/// @return  the configuration; after errors it has holes. Its expressions know their places in `source`
/// @errors  those of `parse`, and `too-large`; everything else that is odd is a warning
cdl::Tree import(const text::SourcePtr& source, const Vocabulary& vocabulary, text::Diagnostics& sink);

/// The same as the text of a file: a comment that says where it is from and what has no counterpart, and the
/// configuration in the canonical layout.
std::string import_as_text(const text::SourcePtr& source, const Vocabulary& vocabulary,
                           text::Diagnostics& sink);

/// True where the text is a historic configuration rather than one of ours.
bool looks_historic(std::string_view text);

}  // namespace mlab::cdl_historic
