#include "mlab/designer/session/core.h"

#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/session/order.h"

namespace mlab::designer {
namespace {

constexpr double kDiskPause = 1.0;                      // between two looks at the files [s]
constexpr std::chrono::milliseconds kLongestWait{250};  // the loop looks around at least so often

}  // namespace

DesignerCore::DesignerCore(DesignerSettings settings, Designer::Send send)
    : settings_(std::move(settings)),
      desk_({settings_.project_folder, settings_.example_folder, settings_.state_folder}),
      clients_(std::move(send)),
      answers_(clients_),
      start_page_(desk_, settings_.version),
      open_texts_(desk_),
      texts_(open_texts_,
             {documents::Drafts(settings_.state_folder, desk_.project().folder()), "in the console"}),
      name_orders_(desk_, texts_),
      questions_(desk_, name_orders_),
      comparisons_(desk_, clients_, answers_, inbox_),
      trials_(desk_, answers_, inbox_, settings_.try_out,
              // So that it stays known what was executed.
              [this] { keeping_.sync(); }),
      fields_(desk_, trials_, answers_, inbox_, programs(), settings_.look_at_run),
      marks_(desk_, trials_, settings_.state_folder),
      test_orders_(desk_, texts_, answers_, inbox_, programs()),
      keeping_(desk_, marks_, settings_.tell_not_kept),
      document_orders_(desk_, clients_, keepers()),
      publisher_({desk_, clients_, start_page_, marks_, test_orders_, comparisons_, keeping_}),
      compiler_(
          programs(),
          [this](const std::string& document, const std::shared_ptr<const Compiled>& compiled) {
            inbox_->post([this, document, compiled] { desk_.take(document, compiled); });
          },
          [this](const std::string& document, const std::shared_ptr<const CheckedCode>& code) {
            inbox_->post([this, document, code] { desk_.take(document, code); });
          }),
      thread_([this] { work(); }) {}

DesignerCore::~DesignerCore() {
  end();
}

std::vector<std::string> DesignerCore::end() {
  ends_ = true;
  jobs_end_.request_stop();
  inbox_->wake();
  if (thread_.joinable()) thread_.join();
  std::vector<std::string> out = desk_.losses();
  for (std::string& loss : marks_.losses()) out.push_back(std::move(loss));
  return out;
}

robot::ProgramSources DesignerCore::programs() const {
  robot::ProgramSources out;
  out.permission = settings_.permission;
  out.include_root = settings_.include_root;
  out.version = settings_.version;
  out.limits = settings_.limits;
  out.ends = jobs_end_.get_token();
  return out;
}

DocumentOrders::Keepers DesignerCore::keepers() {
  return {[this](const OpenConfiguration& document) { marks_.restore(document); },
          [this](const std::string& from, const std::string& to) {
            trials_.rename(from, to);
            marks_.rename(from, to);
          },
          [this](const std::string& document) { marks_.drop(document); }};
}

// ---- from any thread

void DesignerCore::receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message) {
  inbox_->post(
      [this, from, kept = std::shared_ptr<const ToDesigner>(std::move(message))] { take(from, *kept); });
}

void DesignerCore::closed(console::ConnectionId connection) {
  inbox_->post([this, connection] {
    clients_.leave(connection);
    test_orders_.leave(connection);
  });
}

// ---- on the designer's thread

void DesignerCore::work() {
  start_page_.open_first(settings_.open);
  while (!ends_) {
    std::vector<console::Inbox::Task> tasks =
        inbox_->wait_until(std::chrono::steady_clock::now() + kLongestWait);
    while (!ends_) {
      for (const console::Inbox::Task& task : tasks) task();
      tell();
      start_compilations();
      tasks = inbox_->wait_until(std::chrono::steady_clock::now());
      if (tasks.empty()) break;
    }
    clients_.send_beats();
    look_at_disk();
    test_orders_.follow();
  }
  desk_.store().sync_drafts(wall_time());
}

void DesignerCore::tell() {
  keeping_.keep();
  desk_.follow_texts();
  marks_.follow();
  comparisons_.follow();
  test_orders_.follow();
  publisher_.publish();
  answers_.send();
}

void DesignerCore::look_at_disk() {
  const double now = wall_time();
  if (now - last_look_ <= kDiskPause) return;
  last_look_ = now;
  desk_.look_at_disk(now);
  tell();
}

void DesignerCore::start_compilations() {
  while (const OpenConfiguration* document = desk_.next_to_compile()) compiler_.start(desk_.task(*document));
}

void DesignerCore::take(console::ConnectionId from, const ToDesigner& message) {
  const Order order = Order::of(message.body_case());
  const Sender sender = {{from, message.request()}, clients_.of(from)};
  if (order.needs == Order::Needs::kModels) desk_.follow_texts();
  Answer out = answer_for(sender.asker);
  Answered answered = Answered::kNow;
  if (order.from == Order::From::kGreeted && !sender.client.has_greeted)
    refuse(out, "the first message has to be a Greeting");
  else if (order.take == nullptr)
    refuse(out, "this designer does not know that request");
  else
    answered = order.take(*this, sender, message, out);
  if (answered == Answered::kNow) answers_.add(sender.asker, std::move(out));
}

void DesignerCore::greet(const Sender& sender, const Greeting& greeting, Answer& out) {
  if (greeting.protocol() != StartPage::kProtocol) {
    refuse(out, fmt::format("this server speaks protocol {}", StartPage::kProtocol));
    return;
  }
  sender.client.has_greeted = true;
  publisher_.greet(sender.asker.connection);
  if (!start_page_.first_error().empty()) refuse(out, start_page_.first_error());
}

}  // namespace mlab::designer
