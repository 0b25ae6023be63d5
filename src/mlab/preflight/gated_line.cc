#include "mlab/preflight/gated_line.h"

#include <optional>
#include <string>
#include <utility>

namespace mlab::preflight {
namespace {

class GatedLine final : public vehicle::Line {
 public:
  GatedLine(std::string vehicle, std::unique_ptr<vehicle::Line> line, std::shared_ptr<const Permit> permit)
      : vehicle_(std::move(vehicle)), line_(std::move(line)), permit_(std::move(permit)) {}

  std::optional<std::string> hear() override {
    if (auto said = line_->hear()) newest_ = std::move(said);
    return permit_->lets_pass(vehicle_) ? std::exchange(newest_, std::nullopt) : std::nullopt;
  }
  void tell(const wire::VehicleCommand& command) override {
    if (permit_->lets_pass(vehicle_)) line_->tell(command);
  }

 private:
  const std::string vehicle_;
  std::unique_ptr<vehicle::Line> line_;
  std::shared_ptr<const Permit> permit_;
  std::optional<std::string> newest_;  // that was heard, and passes as soon as anything may
};

}  // namespace

std::unique_ptr<vehicle::Line> gated(std::string vehicle, std::unique_ptr<vehicle::Line> line,
                                     std::shared_ptr<const Permit> permit) {
  return std::make_unique<GatedLine>(std::move(vehicle), std::move(line), std::move(permit));
}

}  // namespace mlab::preflight
