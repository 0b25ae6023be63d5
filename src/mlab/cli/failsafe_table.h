#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::cli {

/// A row of what is in force below the programs of a mission's robots.
struct FailsafeRow {
  std::size_t rank = 0;   ///< of what the mission states, from 1; 0: always in force
  std::string robots;     ///< name of their type; empty: all
  std::string condition;  ///< `OUTSIDE Field`
  std::string after;      ///< `5 s`; empty: at once
  std::string action;     ///< `RETURN`
  std::string stated;     ///< where: `4:1`, or `always`
};
/// The highest rank first; nothing where the mission has errors.
std::vector<FailsafeRow> failsafe_rows(const text::SourcePtr& mission);

/// As a table to be read; empty without rows.
std::string table_of(const std::vector<FailsafeRow>& rows);

}  // namespace mlab::cli
