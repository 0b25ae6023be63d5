#pragma once

#include <string>

// What follows from flow::kValueTypes and flow::kQuantities.

namespace mlab::tables {

/// Rows of the page's list of types, quantities first.
std::string value_type_rows();
/// Tables of the documentation.
std::string value_type_documentation();
std::string quantity_documentation();
/// Names as alternatives of a regular expression.
std::string value_type_words();
std::string historic_type_words();
std::string quantity_words();
/// A line for each type in the dictionary of a fuzzer.
std::string value_type_dictionary();

}  // namespace mlab::tables
