#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/flow/program.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/percepts.h"
#include "mlab/training/column.h"

namespace mlab::training {

/// What columns may tell of a robot's body.
struct SeenBody {
  geom::Pose pose;
  double contacts = 0.0;  ///< how often it met something
  double driven = 0.0;    ///< since it was there [m]
  std::span<const percept::RangeReading>
      ranges;  ///< as it stands now; empty: it has no ring, or nobody asked
};

/// The columns that show robots of one program.
///
/// - `PORT`: a number, a truth or a choice is one column; a vector is `PORT.x`, `PORT.y`, `PORT.z`, a point
///   `PORT.x`, `PORT.y`, a pose `PORT.x`, `PORT.y`, `PORT.heading`, all of them or the one that is named
/// - `body.x`, `body.y`, `body.heading`, or all three as `body.pose`; `body.contacts`; `body.driven`
/// - `body.ranges`: the ring's beams, a column each
///
/// In names of ports `*` stands for any number of characters.
class SeenColumns {
 public:
  /// @param ring  of the robots; without beams: they have none
  /// @errors  a sentence: there is no such port, or what it holds is no number
  static std::expected<SeenColumns, std::string> of(const flow::Program& program,
                                                    std::span<const std::string> wanted,
                                                    const binding::RangeRing& ring);

  const std::vector<Column>& columns() const { return columns_; }
  std::size_t count() const { return columns_.size(); }
  /// Something of SeenBody::ranges is shown.
  bool wants_ranges() const { return wants_ranges_; }
  /// Anything else of SeenBody is.
  bool wants_body() const { return wants_body_; }

  /// @param frame  of the program
  /// @param row    `count()` numbers
  void read(const std::byte* frame, const SeenBody& body, double* row) const;

 private:
  enum class Kind : std::uint8_t { kReal, kNumber, kX, kY, kHeading, kContacts, kDriven, kRanges };
  /// Where one column, or all beams, come from.
  struct Source {
    Kind kind = Kind::kReal;
    std::uint32_t offset = 0;          // of a real number in the frame
    const flow::Port* port = nullptr;  // of any other
  };
  bool add_body(const std::string& name, const binding::RangeRing& ring);
  double* read_beams(std::span<const percept::RangeReading> beams, double* row) const;
  std::size_t add_ports(const flow::Program& program, const std::string& pattern);
  void add(std::string name, const std::string& unit, std::string help, const Source& source);

  std::vector<Column> columns_;
  std::vector<Source> sources_;
  std::size_t beams_ = 0;
  bool wants_ranges_ = false;
  bool wants_body_ = false;
};

/// A sentence that says which port is called something like that.
std::string no_such_port(const flow::Program& program, const std::string& name);

}  // namespace mlab::training
