#pragma once

#include <string>

// What follows from percept::kSensors.

namespace mlab::tables {

/// What each sensor of the simulator tells, as a table of the documentation.
std::string sensor_documentation();
/// Their names as alternatives of a regular expression.
std::string sensor_words();
/// A line for each in the dictionary of a fuzzer.
std::string sensor_dictionary();

}  // namespace mlab::tables
