#pragma once

#include "mlab/assist/name.h"
#include "mlab/assist/service.h"

/// What each language answers; service.cc chooses.
namespace mlab::assist {

Completions complete_cdl(const Text& text, std::uint32_t cursor, const Surroundings& around);
Completions complete_cnl(const Text& text, std::uint32_t cursor, const Surroundings& around);
Completions complete_mdl(const Text& text, std::uint32_t cursor, const Surroundings& around);
Completions complete_odl(const Text& text, std::uint32_t cursor, const Surroundings& around);

std::optional<Signature> signature_cdl(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// All names of a text, ascending.
std::vector<Name> names_cdl(const Text& text, const Surroundings& around);
std::vector<Name> names_cnl(const Text& text, const Surroundings& around);
std::vector<Name> names_mdl(const Text& text, const Surroundings& around);
std::vector<Name> names_odl(const Text& text, const Surroundings& around);

std::optional<Hover> hover_cdl(const Text& text, std::uint32_t cursor, const Surroundings& around);
std::optional<Hover> hover_cnl(const Text& text, std::uint32_t cursor, const Surroundings& around);
std::optional<Hover> hover_mdl(const Text& text, std::uint32_t cursor, const Surroundings& around);
std::optional<Hover> hover_odl(const Text& text, std::uint32_t cursor, const Surroundings& around);

std::vector<Symbol> symbols_cdl(const Text& text, const Surroundings& around);
std::vector<Symbol> symbols_cnl(const Text& text, const Surroundings& around);
std::vector<Symbol> symbols_mdl(const Text& text, const Surroundings& around);
std::vector<Symbol> symbols_odl(const Text& text, const Surroundings& around);

std::vector<Hint> hints_cdl(const Text& text, const Surroundings& around);
std::vector<Hint> hints_cnl(const Text& text, const Surroundings& around);
std::vector<Hint> hints_mdl(const Text& text, const Surroundings& around);

/// Tokens that are no names: comments, words, numbers, texts.
std::vector<Shade> tokens_cdl(const Text& text);
std::vector<Shade> tokens_cnl(const Text& text);
std::vector<Shade> tokens_mdl(const Text& text);
std::vector<Shade> tokens_odl(const Text& text);

/// What the C++ of a file of procedures says of their inputs, ascending.
struct CnlScan;
std::vector<Name> code_names(const CnlScan& scan);

std::vector<Name> names_in(const Text& text, const Surroundings& around);
/// A cursor past the end stands at the end.
std::uint32_t within(const Text& text, std::uint32_t cursor);

/// Of the files that texts use no more than these are read for one text.
inline constexpr std::size_t kMostFiles = 64;
/// Two names of one file give the same; what is not there stays as it is.
std::string canonical_path(const std::string& path);

/// The name that the cursor is in or right behind; null where there is none.
const Name* name_at(const std::vector<Name>& names, std::uint32_t cursor);

}  // namespace mlab::assist
