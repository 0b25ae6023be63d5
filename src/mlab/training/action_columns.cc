#include "mlab/training/action_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "mlab/base/angle.h"
#include "mlab/flow/interventions.h"
#include "mlab/flow/limit.h"
#include "mlab/flow/type_words.h"
#include "mlab/text/shown.h"
#include "mlab/training/seen_columns.h"

namespace mlab::training {
namespace {

using flow::TypeKind;
using Role = flow::Port::Role;

// People write degrees, frames hold radians.
bool is_written_in_degrees(const flow::Port& port) {
  return port.edge_unit == "deg" && port.unit != "deg";
}

// Infinite where there is none.
double limit(const flow::Port& port, double edge) {
  if (!flow::is_limit(edge)) return std::copysign(std::numeric_limits<double>::infinity(), edge);
  return is_written_in_degrees(port) ? base::radians(edge) : edge;
}

// Whether numbers set it.
bool takes_numbers(TypeKind kind) {
  return kind == TypeKind::kBool || kind == TypeKind::kInteger || kind == TypeKind::kReal ||
         kind == TypeKind::kVector || kind == TypeKind::kPoint;
}

std::size_t part_count(TypeKind kind) {
  return kind == TypeKind::kVector ? 3 : kind == TypeKind::kPoint ? 2 : 1;
}

std::optional<std::string> why_never(const flow::Program& program, const flow::Port& port,
                                     bool takes_outputs) {
  if (!takes_numbers(port.type->kind))
    return fmt::format("`{}` is {}, which numbers can't set", port.path, flow::value_of(*port.type));
  if (port.role != Role::kOutput) return std::nullopt;
  if (!takes_outputs)
    return fmt::format("`{}` is the output of a node; here parameters and constants are set", port.path);
  return flow::Interventions::why_never_held(program, port);
}

}  // namespace

std::expected<ActionColumns, std::string> ActionColumns::of(const flow::Program& program,
                                                            std::span<const std::string> wanted,
                                                            bool takes_outputs) {
  ActionColumns out;
  for (const std::string& name : wanted) {
    const flow::Port* const port = program.find(name);
    if (port == nullptr) return std::unexpected(no_such_port(program, name));
    if (auto problem = why_never(program, *port, takes_outputs)) return std::unexpected(std::move(*problem));
    if (std::ranges::find(out.values_, port, &Value::port) != out.values_.end())
      return std::unexpected(fmt::format("`{}` is there twice", text::shown(name)));
    const std::size_t count = part_count(port->type->kind);
    out.values_.push_back({port, out.columns_.size(), count});
    if (port->type->kind == TypeKind::kBool)
      out.columns_.push_back({port->path, port->unit, port->help, 0.0, 1.0});
    else if (count == 1)
      out.columns_.push_back(
          {port->path, port->unit, port->help, limit(*port, port->min), limit(*port, port->max)});
    for (std::size_t i = 0; count > 1 && i < count; ++i)
      out.columns_.push_back({port->path + std::array{".x", ".y", ".z"}[i], port->unit, port->help});
    out.is_whole_.resize(out.columns_.size(),
                         port->type->kind == TypeKind::kBool || port->type->kind == TypeKind::kInteger);
  }
  return out;
}

std::optional<std::size_t> ActionColumns::refused(const double* row) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    // What is no number is neither.
    if (!(row[i] >= columns_[i].low && row[i] <= columns_[i].high) || !flow::is_limit(row[i])) return i;
    if (is_whole_[i] != 0 && (row[i] != std::floor(row[i]) || std::fabs(row[i]) > 2147483647.0)) return i;
  }
  return std::nullopt;
}

std::string ActionColumns::why_refused(std::size_t column, double value) const {
  const Column& one = columns_[column];
  const std::string_view what = is_whole_[column] != 0 ? "whole numbers" : "numbers";
  const std::string unit = one.unit.empty() ? "" : " " + one.unit;
  const bool is_open = std::isinf(one.low) && std::isinf(one.high);
  return is_open ? fmt::format("{}: `{}` takes {}", value, one.name, what)
                 : fmt::format("{}: `{}` takes {} from {} to {}{}", value, one.name, what, one.low, one.high,
                               unit);
}

void ActionColumns::write(std::byte* frame, const double* row) const {
  for (const Value& value : values_) {
    std::byte* const at = frame + value.port->offset;
    const double* const from = row + value.first;
    if (value.port->type->kind == TypeKind::kReal) {
      std::memcpy(at, from, sizeof(double));
    } else if (value.port->type->kind == TypeKind::kInteger) {
      const auto whole = static_cast<int>(*from);
      std::memcpy(at, &whole, sizeof whole);
    } else if (value.port->type->kind == TypeKind::kBool) {
      const bool is_so = *from != 0.0;
      std::memcpy(at, &is_so, sizeof is_so);
    } else {
      std::memcpy(at, from, value.count * sizeof(double));
    }
  }
}

std::string ActionColumns::text_of(const Value& value, const double* row) {
  const double* const from = row + value.first;
  if (value.count > 1) return fmt::format("{{{}}}", fmt::join(std::span(from, value.count), ", "));
  if (value.port->type->kind == TypeKind::kBool) return *from != 0.0 ? "true" : "false";
  if (!is_written_in_degrees(*value.port)) return fmt::format("{}", *from);
  // A limit in degrees stays one: it is not to be missed by what turning it into radians and back costs.
  return fmt::format("{}", std::clamp(base::degrees(*from), value.port->min, value.port->max));
}

}  // namespace mlab::training
