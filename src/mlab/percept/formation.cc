#include "mlab/percept/formation_names.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mlab::percept {
namespace {

// Places along a row that is symmetric about its middle: the first rank beside the middle on `first_side`
// (+1 left, -1 right), the second outward on the same side, as the historic tables do for four robots.
double row_place(int rank, int count, double spacing, double first_side) {
  const int half = count / 2;
  if (count % 2 == 0) {
    const double out = (rank % half) * spacing + spacing / 2.0;
    return rank < half ? first_side * out : -first_side * out;
  }
  if (rank == 0) return 0.0;
  const double out = ((rank - 1) % half + 1) * spacing;
  return rank <= half ? first_side * out : -first_side * out;
}

geom::Vector line(int rank, int count, double s, double first_side) {
  return {0.0, row_place(rank, count, s, first_side), 0.0};
}

geom::Vector column(int rank, int count, double s) {
  // Four robots keep the historic order 1, 3, 2, 4: the two halves of a unit interleave.
  const int place = count == 4 && (rank == 1 || rank == 2) ? 3 - rank : rank;
  return {(count - 1) * s / 2.0 - place * s, 0.0, 0.0};
}

// Sum of the rows of all ranks where rank r stands in row (r + 1) / 2.
double row_sum(int count) {
  const double n = count;
  return std::floor(n * n / 4.0);
}

// A V with its point ahead: the pair of rank r stands r/2 behind and r/2 beside the leader.
geom::Vector vee(int rank, int count, double s, double first_side) {
  const auto at = [&](int r) -> geom::Vector {
    const int row = (r + 1) / 2;
    const double side = r % 2 == 1 ? first_side : -first_side;
    return {-row * s / 2.0, side * row * s / 2.0, 0.0};
  };
  // Rows are filled in pairs; with an even number of robots the last one stands alone on the first side.
  const geom::Vector mean{-row_sum(count) * s / 2.0 / count, count % 2 == 0 ? first_side * s / 4.0 : 0.0,
                          0.0};
  return at(rank) - mean;
}

geom::Vector wedge(int rank, int count, double s, double first_side) {
  if (count == 2)
    return {rank == 0 ? s / 2.0 : -s / 2.0, (rank == 0 ? first_side : -first_side) * s / 2.0, 0.0};
  if (count == 3) {
    const double side = rank == 1 ? 1.0 : -1.0;
    return rank == 0 ? geom::Vector{2.0 * s / 3.0, 0.0, 0.0} : geom::Vector{-s / 3.0, side * s / 3.0, 0.0};
  }
  if (count == 4) {
    const double side = rank < 2 ? -1.0 : 1.0;
    return rank % 2 == 0 ? geom::Vector{s / 2.0, side * s / 2.0, 0.0}
                         : geom::Vector{-s / 2.0, side * 1.5 * s, 0.0};
  }
  return vee(rank, count, s, first_side);
}

// Along the outline of a square that stands on its corner, the leader at the front corner, neighbours s
// apart.
geom::Vector diamond(int rank, int count, double s) {
  if (count == 2) return line(rank, count, s, -1.0);
  if (count == 3) return wedge(rank, count, s, -1.0);
  if (count == 4) {
    constexpr std::array<geom::Vector, 4> kCorners = {{{1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}}};
    return kCorners[static_cast<std::size_t>(rank)] * s;
  }
  const double side_length = count * s / 4.0;
  const double half_diagonal = side_length / std::numbers::sqrt2;
  const auto at = [&](int r) -> geom::Vector {
    const int row = (r + 1) / 2;
    const double walked = row * s;  // from the front corner, along the outline
    const double side = r % 2 == 1 ? -1.0 : 1.0;
    const double along = walked / std::numbers::sqrt2;
    const double out = walked <= side_length ? along : 2.0 * half_diagonal - along;
    return {half_diagonal - along, side * out, 0.0};
  };
  // Pairs stand opposite each other, and who stands alone stands in the rear corner: sideways all is
  // balanced.
  const geom::Vector mean{half_diagonal - row_sum(count) * s / std::numbers::sqrt2 / count, 0.0, 0.0};
  return at(rank) - mean;
}

geom::Vector computed_station(Formation formation, int rank, int count, double spacing) {
  switch (formation) {
    case Formation::kLine:
    case Formation::kLineLeft:
      return line(rank, count, spacing, -1.0);
    case Formation::kLineRight:
      return line(rank, count, spacing, count == 2 ? 1.0 : -1.0);
    case Formation::kWedge:
    case Formation::kWedgeLeft:
      return wedge(rank, count, spacing, -1.0);
    case Formation::kWedgeRight:
      return wedge(rank, count, spacing, 1.0);
    case Formation::kDiamond:
      return diamond(rank, count, spacing);
    case Formation::kColumn:
      return column(rank, count, spacing);
    case Formation::kNone:
    case Formation::kSweep:
      break;
  }
  return {};
}

}  // namespace

// Each robot asks for its own several times a cycle, and its neighbours for theirs: each thread remembers
// some.
geom::Vector station(Formation formation, int rank, int count, double spacing) {
  if (count <= 1) return {};
  struct Known {
    Formation formation = Formation::kNone;
    int rank = 0;
    int count = 0;
    double spacing = 0.0;
    geom::Vector place;
  };
  constexpr std::size_t kHeld = 16;
  static thread_local std::array<Known, kHeld> held;
  Known& one = held[static_cast<std::size_t>(rank) % kHeld];
  if (one.formation != formation || one.rank != rank || one.count != count || one.spacing != spacing)
    one = {formation, rank, count, spacing, computed_station(formation, rank, count, spacing)};
  return one.place;
}

std::string_view name(Formation formation) {
  const auto index = static_cast<std::size_t>(formation);
  return index < kFormations.size() ? kFormations[index].name : "?";
}

std::optional<Formation> formation_named(std::string_view wanted) {
  const auto same = [](std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::tolower(static_cast<unsigned char>(a[i])) != std::tolower(static_cast<unsigned char>(b[i])))
        return false;
    }
    return true;
  };
  for (const FormationInfo& one : kFormations) {
    if (same(one.name, wanted)) return one.formation;
  }
  return std::nullopt;
}

}  // namespace mlab::percept
