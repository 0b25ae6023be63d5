#pragma once

#include <string>

#include "mlab/designer.pb.h"
#include "mlab/designer/session/desk.h"

namespace mlab::designer {

/// What there is to open, as the start page shows it.
class StartPage {
 public:
  /// @param version  of mlab
  StartPage(Desk& desk, std::string version) : desk_(desk), version_(std::move(version)) {}

  static constexpr std::uint32_t kProtocol = 1;

  /// Opens the file that the command line named.
  void open_first(const std::string& disk_path);
  /// Why that could not be opened; empty: it could.
  const std::string& first_error() const { return first_error_; }
  Hello hello() const;
  Lists lists() const;

 private:
  Desk& desk_;
  const std::string version_;
  std::string first_;  ///< path of the document that the command line named
  std::string first_error_;
};

}  // namespace mlab::designer
