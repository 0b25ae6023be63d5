#include "mlab/console/session/name_orders.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/text/utf8.h"

namespace mlab::console {
namespace {

Answered refused(const project::NoAnswer& why, Reply& reply) {
  if (!why.path.empty()) {
    names::TextPlace& place = *reply.mutable_place();
    place.set_path(why.path);
    place.set_can_open(true);
    place.set_begin(why.span.begin);
    place.set_end(why.span.end);
  }
  return why.why;
}

}  // namespace

NameOrders::NameOrders(OpenDocuments& documents, DocumentOrders& orders, RunMaker& maker,
                       project::ProjectTexts::Elsewhere elsewhere)
    : open_(documents, [&maker] { maker.forget_programs(); }),
      texts_(open_, std::move(elsewhere)),
      orders_(orders),
      // Texts are shown whatever they are of; some only to be read.
      names_(texts_, [](const std::string& path) { return !path.empty(); }) {}

Answered NameOrders::find_definition(const FindDefinition& find, Reply& reply) {
  const auto text = texts_.read(find.at().document());
  if (!text) return text.error().message;
  const auto found = names_.definition(*text, find.at().cursor());
  if (!found) return refused(found.error(), reply);
  *reply.mutable_place() = names_.place_message(*found);
  return std::nullopt;
}

Answered NameOrders::find_uses(const FindUses& find, Reply& reply) {
  const auto text = texts_.read(find.at().document());
  if (!text) return text.error().message;
  auto found = names_.uses(*text, find.at().cursor());
  if (!found) return refused(found.error(), reply);
  *reply.mutable_uses() = std::move(*found);
  return std::nullopt;
}

Answered NameOrders::read_text(const ReadText& read, Reply& reply) {
  const auto text = texts_.read(read.path());
  if (!text) return text.error().message;
  reply.mutable_text()->set_path(read.path());
  reply.mutable_text()->set_text(text::as_utf8(text->source->text()));
  return std::nullopt;
}

Answered NameOrders::plan(const PlanRename& wanted, Reply& reply) {
  const auto text = texts_.read(wanted.at().document());
  if (!text) return text.error().message;
  auto found = names_.plan(*text, wanted.at().cursor(), wanted.name());
  if (!found) return refused(found.error(), reply);
  *reply.mutable_plan() = std::move(*found);
  return std::nullopt;
}

Answered NameOrders::rename(const Sender& sender, const RenameEverywhere& wanted, Reply& reply) {
  const auto text = texts_.read(wanted.at().document());
  if (!text) return text.error().message;
  auto done = names_.rename(*text, wanted.at().cursor(), wanted.name(), wanted.seal(), wall_time());
  if (!done) return refused(done.error(), reply);
  *reply.mutable_plan() = std::move(*done);
  return orders_.changed(sender, true,
                         fmt::format("rename {} to {}", reply.plan().from(), reply.plan().to()));
}

}  // namespace mlab::console
