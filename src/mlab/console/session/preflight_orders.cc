#include "mlab/console/session/preflight_orders.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/published/preflight_encoder.h"

namespace mlab::console {
namespace {

constexpr double kApart = 2.0;  // between two looks at vehicles, while nobody asks for one [s]

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

preflight::Signature signature_of(const SignPreflight& wanted) {
  preflight::Signature out;
  out.by = wanted.by();
  out.confirmed.assign(wanted.confirmed().begin(), wanted.confirmed().end());
  for (const Preflight::Acceptance& one : wanted.accepted())
    out.accepted.push_back({one.item(), one.because()});
  return out;
}

}  // namespace

PreflightOrders::PreflightOrders(const Parts& parts) : parts_(parts) {
  if (parts_.settings.gate) workshop_ = std::make_unique<Workshop>();
}

PreflightOrders::CrewPtr PreflightOrders::crew() const {
  const LiveRun* const live = std::as_const(parts_.run).live();
  return live == nullptr || parts_.run.is_expected() ? nullptr : live->crew();
}

bool PreflightOrders::has_started() const {
  const LiveRun* const live = std::as_const(parts_.run).live();
  return live != nullptr && live->was_started();
}

void PreflightOrders::follow() {
  if (!workshop_) return;
  const bool is_other = known_run_ != parts_.run.run_number() || known_plan_ != parts_.run.plan_revision();
  if (is_other) {
    known_run_ = parts_.run.run_number();
    known_plan_ = parts_.run.plan_revision();
    ++number_;
    is_looking_ = false;
    looked_ = looked_at_ = 0.0;
    checklist_.reset();
    held_ = std::unexpected(std::string());
    ++revision_;
  }
  const CrewPtr known = crew();
  const bool is_due = looked_ == 0.0 || (!has_started() && wall_time() >= looked_ + kApart);
  if (known && is_due && !is_looking_ && !preflight::hosts_of(*known->mission).empty()) look(known);
}

void PreflightOrders::look(const CrewPtr& crew) {
  is_looking_ = true;
  workshop_->start([this, number = ++number_, crew, gate = parts_.settings.gate] {
    auto checklist = std::make_shared<preflight::Checklist>(gate->look(*crew));
    auto held = std::make_shared<Held>(gate->held(*crew));
    parts_.inbox.post([this, number, crew, checklist,
                       held] { take(number, crew, std::move(*checklist), std::move(*held)); },
                      Inbox::Kind::kDuringCycle);
  });
}

void PreflightOrders::take(std::uint64_t number, const CrewPtr& crew, preflight::Checklist checklist,
                           Held held) {
  if (number != number_ || crew != this->crew()) return;
  is_looking_ = false;
  looked_ = wall_time();
  looked_at_ = clock_seconds();
  const bool is_signed_alike = held_.has_value() == held.has_value() && (!held || *held_ == *held) &&
                               (held || held_.error() == held.error());
  const bool is_known = checklist_ && *checklist_ == checklist && is_signed_alike;
  checklist_ = std::make_unique<preflight::Checklist>(std::move(checklist));
  held_ = std::move(held);
  if (!is_known) ++revision_;
}

Answered PreflightOrders::check(const CheckVehicles& /*asked*/) {
  const CrewPtr known = crew();
  if (!workshop_) return "this run has no fleet: nothing is looked at";
  if (!known) return "there is no mission that could run";
  if (preflight::hosts_of(*known->mission).empty()) return "this mission has no vehicles";
  if (!is_looking_) look(known);
  ++revision_;
  return std::nullopt;
}

Answered PreflightOrders::sign(const Sender& sender, const SignPreflight& wanted, const Reply& reply) {
  const CrewPtr known = crew();
  if (!workshop_ || !known || !checklist_) return "there is nothing to be signed";
  const std::string who = sender.client.name;
  workshop_->start([this, known, to = sender.channel.connection(), request = reply.request(), who,
                    signature = signature_of(wanted), gate = parts_.settings.gate] {
    auto made = std::make_shared<Held>(gate->sign(*known, signature));
    parts_.inbox.post(
        [this, known, to, request, who, made] {
          ToBrowser out;
          out.mutable_reply()->set_request(request);
          out.mutable_reply()->set_ok(made->has_value());
          if (!*made) out.mutable_reply()->set_error(made->error());
          if (*made && known == crew()) {
            parts_.run.note(who,
                            fmt::format("the pre-flight checklist is signed by {}", (*made)->signature.by));
            take(++number_, known, (*made)->checklist, *made);
          }
          parts_.people.send(to, out);
        },
        Inbox::Kind::kDuringCycle);
  });
  return std::nullopt;
}

void PreflightOrders::encode(Preflight& out) const {
  if (!workshop_) return;
  const CrewPtr known = crew();
  const bool is_coming = !checklist_ && known && !preflight::hosts_of(*known->mission).empty();
  out.set_is_looking(is_looking_ || is_coming);
  out.set_has_vehicles(is_coming || (checklist_ && !checklist_->vehicles.empty()));
  if (!checklist_ || checklist_->vehicles.empty()) return;
  encode_checklist(*checklist_, out);
  out.set_looked_at(looked_at_);
  out.set_unchecked(clean(parts_.settings.gate->unchecked()));
  out.set_is_needed(checklist_->is_needed() && out.unchecked().empty());
  if (held_) encode_signature(held_->signature, out);
  if (out.is_needed() && !held_ && !has_started()) out.set_why_not_start(clean(held_.error()));
}

}  // namespace mlab::console
