#include "mlab/designer/edit/spread.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/edit.h"

namespace mlab::designer {
namespace {

// Between nodes a wire has to be seen, between states what is written at a transition. [pixels]
constexpr double kNodeRoomAcross = 40.0;
constexpr double kNodeRoomDown = 24.0;
constexpr double kStateRoomAcross = 96.0;
constexpr double kStateRoomDown = 56.0;

std::vector<std::size_t> order_by(const std::vector<DrawnBox>& boxes, double DrawnBox::* coordinate) {
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return boxes[i].*coordinate; });
  return order;
}

/// Whether two boxes stand in one row, as their author saw it.
bool share_row(const DrawnBox& a, const DrawnBox& b) {
  return std::abs(a.y - b.y) < 0.5 * std::min(a.size.height, b.size.height);
}

// What a thing takes of one direction, and across it [px].
struct Extent {
  double at = 0.0;
  double size = 0.0;
  double across_at = 0.0;
  double across_size = 0.0;
};

Extent extent_of(const DrawnBox& box, bool goes_right) {
  return goes_right ? Extent{box.x, box.size.width, box.y, box.size.height}
                    : Extent{box.y, box.size.height, box.x, box.size.width};
}

// How far all of them have to go in one direction until none lies on what is there.
double way_until_free(const std::vector<DrawnBox>& boxes, const std::vector<DrawnBox>& taken,
                      bool goes_right) {
  constexpr double kRoom = 24.0;                  // [px]
  constexpr double kPitch = 12.0;                 // of the canvas [px]
  std::vector<std::pair<double, double>> barred;  // ways at which one lies on another: from, to
  for (const DrawnBox& box : boxes) {
    const Extent own = extent_of(box, goes_right);
    for (const DrawnBox& there : taken) {
      const Extent other = extent_of(there, goes_right);
      const bool passes = own.across_at >= other.across_at + other.across_size + kRoom / 2 ||
                          other.across_at >= own.across_at + own.across_size + kRoom / 2;
      const double to = other.at + other.size + kRoom - own.at;
      if (!passes && to > 0.0) barred.emplace_back(other.at - own.at - own.size - kRoom / 2, to);
    }
  }
  std::ranges::sort(barred);
  double way = 0.0;
  for (const auto& [from, to] : barred) {
    if (from < way && way < to - kRoom / 2) way = std::ceil(to / kPitch) * kPitch;
  }
  return way;
}

}  // namespace

std::pair<double, double> way_aside(const std::vector<DrawnBox>& boxes, const std::vector<DrawnBox>& taken) {
  const double right = way_until_free(boxes, taken, true);
  const double down = way_until_free(boxes, taken, false);
  return right < down ? std::pair(right, 0.0) : std::pair(0.0, down);
}

void spread(std::vector<DrawnBox>& boxes, double room_across, double room_down) {
  const std::vector<DrawnBox> before = boxes;
  double last = 0.0;
  const std::vector<std::size_t> columns = order_by(before, &DrawnBox::x);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const DrawnBox& box = before[columns[k]];
    double at = k == 0 ? box.x : last + box.x - before[columns[k - 1]].x;
    for (std::size_t j = 0; j < k; ++j) {
      const DrawnBox& other = before[columns[j]];
      if (other.x < box.x && share_row(other, box))
        at = std::max(at, boxes[columns[j]].x + other.size.width + room_across);
    }
    boxes[columns[k]].x = last = at;
  }
  const std::vector<std::size_t> rows = order_by(before, &DrawnBox::y);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    DrawnBox& box = boxes[rows[k]];
    double at = k == 0 ? box.y : last + before[rows[k]].y - before[rows[k - 1]].y;
    for (std::size_t j = 0; j < k; ++j) {
      const DrawnBox& other = boxes[rows[j]];
      const bool is_beside = box.x >= other.x + other.size.width + room_across ||
                             other.x >= box.x + box.size.width + room_across;
      if (!is_beside) at = std::max(at, other.y + other.size.height + room_down);
    }
    box.y = last = at;
  }
}

std::vector<DrawnBox> placed_boxes(const Drawing& drawing) {
  std::vector<DrawnBox> out;
  for (const Node& node : drawing.nodes()) {
    if (node.has_x() && node.has_y())
      out.push_back({node.name(), node.x(), node.y(), size_of(node, drawing)});
  }
  for (const State& state : drawing.states()) {
    if (state.has_x() && state.has_y()) out.push_back({state.name(), state.x(), state.y(), size_of(state)});
  }
  return out;
}

std::string spread_out(std::string text, const cdl::Environment& environment) {
  const auto model =
      std::make_shared<Model>(std::make_shared<const text::Source>("imported.cdl", text), environment);
  if (!model->is_readable()) return text;
  const DrawingContext context{"imported.cdl", 1, false, [](std::string_view) { return std::string(); }};
  Edit edit;
  for (const cdl::Item& item : model->tree().items) {
    const auto* layout = std::get_if<cdl::Layout>(&item);
    if (layout == nullptr) continue;
    const Drawing drawing = draw(*model, layout->owner.text, context);
    std::vector<DrawnBox> boxes = placed_boxes(drawing);
    const bool is_states = drawing.kind() == Drawing::STATES;
    spread(boxes, is_states ? kStateRoomAcross : kNodeRoomAcross, is_states ? kStateRoomDown : kNodeRoomDown);
    if (boxes.empty()) continue;
    Arrange& arrange = *edit.add_changes()->mutable_arrange();
    arrange.set_page(layout->owner.text);
    for (const DrawnBox& box : boxes) {
      Arrange::At& at = *arrange.add_nodes();
      at.set_node(box.name);
      at.set_x(box.x);
      at.set_y(box.y);
    }
  }
  if (edit.changes().empty()) return text;
  text::Result<Edited> done = edited(model, environment, edit);
  return done ? std::move(done->text) : text;
}

}  // namespace mlab::designer
