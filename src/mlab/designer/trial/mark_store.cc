#include "mlab/designer/trial/mark_store.h"

#include <cstddef>
#include <memory>

#include "mlab/text/source.h"

namespace mlab::designer {
namespace {

constexpr std::size_t kMostBytes = text::Source::kMaxBytes + Marks::kMost * 16'000;

std::string kept_in(std::string_view document) {
  return documents::StateFolder::name_of(document, ".marks");
}

}  // namespace

std::string MarkStore::keep(const std::string& document, const Marks& marks) const {
  if (marks.is_empty()) return drop(document);
  KeptMarks kept;
  kept.set_document(document);
  marks.encode(kept);
  return folder_.write(kept_in(document), kept.SerializeAsString());
}

std::string MarkStore::drop(std::string_view document) const {
  return folder_.remove(kept_in(document));
}

std::optional<Marks> MarkStore::find(std::string_view document, const cdl::Environment& environment) const {
  std::string bytes;
  KeptMarks kept;
  if (!folder_.read(kept_in(document), kMostBytes, bytes) || !kept.ParseFromString(bytes) ||
      kept.document() != document)
    return std::nullopt;
  auto source = std::make_shared<const text::Source>(kept.document(), kept.text());
  return Marks::restored(kept, std::make_shared<const Model>(std::move(source), environment));
}

}  // namespace mlab::designer
