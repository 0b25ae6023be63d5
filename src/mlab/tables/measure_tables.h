#pragma once

#include <string>

namespace mlab::tables {

/// The numbers of `Measure.Kind` in console_map.proto.
std::string measure_enum();
/// TypeScript: a row for each kind.
std::string measure_rows();
/// Documentation: what each kind is, and how its statement is written.
std::string measure_documentation();
std::string measure_grammar();
/// Words of overlays, for editors and fuzzers.
std::string odl_named_words();
std::string odl_feature_words();
std::string odl_feature_string();
std::string odl_dictionary();

}  // namespace mlab::tables
