#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/comparison/comparison.h"

// A comparison in words, for terminals and pages.
namespace mlab::comparison {

/// What came out, in a sentence: `they part after cycle 2 (0.2 s)`.
std::string verdict(const Comparison& comparison);
/// Of which file, which mission, and how it ended: `demo_c.mdl, seed 1, 327.7 s, done`.
std::string words_of(const Side& side);
/// Which value of whom differs: `robot 1, `noise`: (1, 0, 0) in A, (2, 0, 0) in B`.
std::string words_of(const Parting& parting);
/// `robots 1 to 4, 7`, at most a few of them by name.
std::string robots_words(const std::vector<std::uint32_t>& robots);
/// What was compared where it was not everything, as a sentence; empty: it was.
std::string compared_words(const Comparison& comparison);
/// Where they part nowhere: what is the same.
std::string same_words(const Comparison& comparison);
/// Of which robots only one run has any, as sentences: `robots 5, 7 are in B alone`.
std::vector<std::string> alone_words(const Comparison& comparison);
/// `only in A`, `only in B`, `not started`; empty: it is in both.
std::string where_it_is(const RobotRow& row);
/// How a command went: `12.3 to 45.6 s, done`; empty: not at all.
std::string words_of(const std::optional<CommandRow::Times>& times);
/// `12.3`, empty for nothing [s].
std::string seconds(const std::optional<double>& time);

}  // namespace mlab::comparison
