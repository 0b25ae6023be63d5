#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <vector>

#include "mlab/ways/clearing.h"
#include "mlab/ways/tangents.h"

namespace mlab::ways {

/// A way round everything that stands on a ground: straight pieces, and arcs round things that are given as
/// corners of a line which goes round outside of them.
struct Way {
  std::vector<geom::Point> corners;  ///< from where it begins to where it ends [m, world]
  double length = 0.0;               ///< [m]; with arcs as arcs
  double clearance = 0.0;            ///< that it keeps from everything [m], but for its ends
};

/// The shortest ways on a ground at one clearance, by a search over the tangents of everything that has grown
/// by it, which are found as the search comes to them and kept for the next one. A shortest way among discs
/// consists of such tangents and of arcs, so there is one wherever one can be. Belongs to one thread at a
/// time; what it finds does not depend on what it was asked before.
/// @source  Y.-H. Liu, S. Arimoto, International Journal of Robotics Research 11(4), 1992 (tangent graphs);
///          P. Hart, N. Nilsson, B. Raphael, 1968 (A*)
class Planner {
 public:
  /// @param ground  outlives this
  Planner(const Ground& ground, double clearance)
      : clearing_(ground, clearance),
        first_reach_(first_reach(clearing_.rounds())),
        circles_(2 * clearing_.rounds().size()),
        arcs_(clearing_.rounds().size()),
        effort_(circles_.size()) {}

  const Clearing& clearing() const { return clearing_; }

  /// No way was found.
  struct NoWay {
    bool is_certain = false;  ///< there is none; else the search was given up
    geom::Point
        nearest;  ///< to where it should lead, of the places that were reached where ways turn [m, world]
  };
  static constexpr std::uint64_t kNoLimit = UINT64_MAX;
  /// @param from, to     free places of the clearing
  /// @param most_effort  after so much more the search is given up
  std::expected<Way, NoWay> find(geom::Point from, geom::Point to, std::uint64_t most_effort = kNoLimit);
  /// Tangents that were looked at, by all searches together, and circles that were laid out: what most of the
  /// time goes into.
  std::uint64_t effort() const { return effort_; }

 private:
  /// A free tangent that leaves a circle.
  struct Piece {
    Tangent tangent;
    std::uint32_t to = 0;     // circle
    double from_angle = 0.0;  // where it leaves the circle [rad]
    double to_angle = 0.0;    // where it meets the other one [rad]
  };
  /// Those of a circle's pieces that lead about equally far.
  struct Ring {
    double reach = 0.0;             // to all rounds nearer than this, but for those of the rings before [m]
    std::uint32_t first_piece = 0;  // its pieces' numbers begin here
    std::vector<Piece> pieces;
  };
  /// A round gone round in one sense: the rings of pieces that some search has come to, the nearest first.
  struct Circle {
    std::vector<Ring> rings;
  };
  /// What a search has come to: a piece, and where it comes from.
  struct Step {
    Piece piece;
    double cost = 0.0;         // to its end [m]
    std::int32_t before = -1;  // step; -1: it begins the way
  };
  struct Search;

  const Round& round(std::uint32_t circle) const { return clearing_.rounds()[circle / 2]; }
  static Sense sense(std::uint32_t circle) {
    return circle % 2 == 0 ? Sense::kCounterClockwise : Sense::kClockwise;
  }
  double angle(std::uint32_t circle, geom::Point at) const { return direction(at - round(circle).center); }
  static double first_reach(std::span<const Round> rounds);
  const std::vector<Arc>& arcs(std::uint32_t round);
  bool is_open(std::uint32_t circle, double angle, double by);
  const Ring& known(std::uint32_t circle, std::uint32_t ring);
  Ring next_ring(std::uint32_t circle);
  double cost_round(const Step& arrived, double leaving);
  void begin(Search& search);
  void begin_by(std::uint32_t round_number, Search& search);
  bool has_next(Search& search);
  bool is_blocked(const Step& step) const;
  void go_on(Search& search, std::int32_t step);
  void go_on_by(std::uint32_t ring, std::int32_t step, Search& search);
  Way way_of(const Search& search, std::int32_t last) const;

  Clearing clearing_;
  double first_reach_;  // of the first ring of each circle [m]
  std::vector<Circle> circles_;
  std::vector<std::optional<std::vector<Arc>>> arcs_;  // by round
  std::uint32_t pieces_ = 0;
  std::vector<double> best_;             // by piece: of the search that is under way
  std::vector<std::uint32_t> improved_;  // pieces whose best it has found
  std::uint64_t effort_;
};

}  // namespace mlab::ways
