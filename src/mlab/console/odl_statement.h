#pragma once

#include <cstddef>
#include <string>

#include "mlab/console.pb.h"
#include "mlab/console/splices.h"
#include "mlab/geom/pose.h"
#include "mlab/lang/odl/tree.h"
#include "mlab/overlay/overlay.h"

namespace mlab::console {

/// To 0.01, without zeros at its end: `12.5`. A length that would become 0 that way keeps its first digits.
std::string brief_number(double value);
/// Two of them; the origin in force where it is to stand is taken off.
std::string brief_point(geom::Point world, geom::Offset origin);

/// What keeps a thing from being written; empty: nothing.
std::string problem_with(const Measure& measure);
std::string problem_with(const Obstacle& obstacle);
std::string problem_with(const WorldObject& object);

/// The statements that say these. The thing has no problem.
std::string odl_statement(const Measure& measure, geom::Offset origin);
std::string odl_statement(const Obstacle& obstacle, geom::Offset origin);
std::string odl_statement(const WorldObject& object, geom::Offset origin);

/// Changes the words of statements, so that they say something else.
class StatementEdit {
 public:
  /// @param origin  in force, for points whose statement does not tell it
  StatementEdit(Splices& splices, const odl::Tree& tree, const odl::Statement& statement, geom::Offset origin)
      : splices_(splices), tree_(tree), statement_(statement), origin_(origin) {}

  void replace(const overlay::ControlMeasure& before, const Measure& after);
  void replace(const overlay::ObstacleDisc& before, const Obstacle& after);
  void replace(const overlay::WorldObject& before, const WorldObject& after);
  void erase() { splices_.erase(statement_.span); }

 private:
  void rewrite(const std::string& statement);
  void name(const overlay::ControlMeasure& before, const Measure& after);
  void size(double before, double after, overlay::MeasureKind kind);
  void points(const std::vector<odl::PointSyntax>& written, const std::vector<geom::Point>& before,
              const std::vector<geom::Point>& after);
  void point(const odl::PointSyntax& written, geom::Point before, geom::Point after);
  void number(text::Span word, double before, double after);
  text::Span first_word(const odl::PointSyntax& point) const;
  text::Span last_word(const odl::PointSyntax& point) const;

  Splices& splices_;
  const odl::Tree& tree_;
  const odl::Statement& statement_;
  geom::Offset origin_;
  std::size_t last_point_ = 0;  // of those written ones that stay
};

/// Differences below this are none [m].
inline constexpr double kSameNumber = 1e-6;

}  // namespace mlab::console
