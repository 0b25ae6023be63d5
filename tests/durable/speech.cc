// The console and the designer, as the author of author.h talks to them.

#include "author.h"

#include "mlab/console.pb.h"
#include "mlab/designer.pb.h"

namespace mlab::durable {
namespace {

// Fills a message and gives its bytes.
template <class Message, class Fill>
std::string bytes_of(std::uint32_t request, Fill&& fill) {
  Message out;
  out.set_request(request);
  fill(out);
  return out.SerializeAsString();
}

class ConsoleSpeech : public Speech {
  using Message = console::ToServer;

  std::vector<std::string> arguments() const override { return {"run", "m.mdl"}; }
  std::string path() const override { return "/session"; }
  std::vector<std::string> documents() const override { return {"m.odl", "m.mdl"}; }
  std::string comment(const std::string& word) const override { return "-- " + word + "\n"; }

  std::vector<std::string> greeting() const override {
    return {bytes_of<Message>(0, [](Message& out) { out.mutable_hello()->set_protocol(1); })};
  }
  HeardAnswer hear(const std::string& message) const override {
    console::ToBrowser in;
    HeardAnswer out;
    if (!in.ParseFromString(message)) return out;
    if (in.has_reply()) out = {in.reply().request(), in.reply().ok(), in.reply().error(), {}};
    for (const auto& document : in.documents().documents())
      out.texts[document.path()] = {document.text(), document.revision()};
    return out;
  }
  std::string insert(std::uint32_t request, const std::string& document, std::uint64_t revision,
                     const std::string& text, const std::string& name) const override {
    return bytes_of<Message>(request, [&](Message& out) {
      console::EditText& edit = *out.mutable_edit_text();
      edit.set_document(document);
      edit.set_revision(revision);
      edit.set_text(text);
      edit.set_name(name);
    });
  }
  std::string add_thing(std::uint32_t request, const std::string& name) const override {
    return bytes_of<Message>(request, [&](Message& out) {
      out.mutable_edit_map()->set_name("add " + name);
      console::Measure& measure = *out.mutable_edit_map()->add_changes()->mutable_add_measure();
      measure.set_kind(console::Measure::PASSAGE_POINT);
      measure.set_name(name);
      measure.add_points()->set_x(100.0);
      measure.mutable_points(0)->set_y(100.0);
    });
  }
  std::string undo(std::uint32_t request, const std::string& /*document*/) const override {
    return bytes_of<Message>(request, [](Message& out) { out.mutable_undo(); });
  }
  std::string save(std::uint32_t request, const std::string& document) const override {
    return bytes_of<Message>(request,
                             [&](Message& out) { out.mutable_save_documents()->add_documents(document); });
  }
};

class DesignerSpeech : public Speech {
  using Message = designer::ToDesigner;

  std::vector<std::string> arguments() const override { return {"edit", "c.cdl"}; }
  std::string path() const override { return "/designer"; }
  std::vector<std::string> documents() const override { return {"c.cdl", "d.cdl"}; }
  std::string comment(const std::string& word) const override { return "// " + word + "\n"; }

  std::vector<std::string> greeting() const override {
    std::vector<std::string> out = {
        bytes_of<Message>(0, [](Message& hello) { hello.mutable_greeting()->set_protocol(1); })};
    for (const std::string& document : documents())
      out.push_back(bytes_of<Message>(0, [&](Message& open) { open.mutable_open()->set_path(document); }));
    return out;
  }
  HeardAnswer hear(const std::string& message) const override {
    designer::FromDesigner in;
    HeardAnswer out;
    if (!in.ParseFromString(message)) return out;
    if (in.has_answer()) out = {in.answer().request(), in.answer().ok(), in.answer().error(), {}};
    if (in.has_document()) out.texts[in.document().path()] = {in.document().text(), in.document().revision()};
    return out;
  }
  std::string insert(std::uint32_t request, const std::string& document, std::uint64_t revision,
                     const std::string& text, const std::string& name) const override {
    return bytes_of<Message>(request, [&](Message& out) {
      designer::EditText& edit = *out.mutable_edit_text();
      edit.set_document(document);
      edit.set_revision(revision);
      edit.set_text(text);
      edit.set_name(name);
    });
  }
  std::string add_thing(std::uint32_t request, const std::string& name) const override {
    return bytes_of<Message>(request, [&](Message& out) {
      out.mutable_edit()->set_document(documents().front());
      designer::AddDeclaration& added = *out.mutable_edit()->add_changes()->mutable_add_declaration();
      added.set_kind("assemblage");
      added.set_name(name);
    });
  }
  std::string undo(std::uint32_t request, const std::string& document) const override {
    return bytes_of<Message>(request, [&](Message& out) { out.mutable_undo()->set_document(document); });
  }
  std::string save(std::uint32_t request, const std::string& document) const override {
    return bytes_of<Message>(request, [&](Message& out) { out.mutable_save()->set_document(document); });
  }
};

}  // namespace

std::unique_ptr<Speech> console_speech() {
  return std::make_unique<ConsoleSpeech>();
}
std::unique_ptr<Speech> designer_speech() {
  return std::make_unique<DesignerSpeech>();
}

}  // namespace mlab::durable
