#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/difference/difference.h"

namespace mlab::designer {

/// A document compared with another version of it. Compares when it is asked and something has changed. For
/// one thread.
class Comparing {
 public:
  /// @param title     what the other version is called: `the saved file`
  /// @param is_saved  it is the saved file, which may be saved anew
  Comparing(std::string title, std::shared_ptr<const Model> base, bool is_saved)
      : title_(std::move(title)), base_(std::move(base)), is_saved_(is_saved) {}

  bool is_with_saved() const { return is_saved_; }
  const Model& base() const { return *base_; }
  /// The other version is another one by now.
  void set_base(std::shared_ptr<const Model> base);
  /// The document as it is drawn.
  void set_now(std::shared_ptr<const Model> now);
  /// Grows when something has changed.
  std::uint64_t number() const { return number_; }

  /// All that differs; without the document's path.
  Differences list() const;
  /// What differs on a page of the document. What has gone is drawn as it was.
  /// @param context  of the document
  PageDifference page(const std::string& path, const DrawingContext& context) const;

 private:
  const difference::Comparison& comparison() const;

  std::string title_;
  std::shared_ptr<const Model> base_;
  std::shared_ptr<const Model> now_;
  bool is_saved_ = false;
  std::uint64_t number_ = 0;
  mutable std::uint64_t compared_ = 0;  // number that `comparison_` is of
  mutable difference::Comparison comparison_;
};

}  // namespace mlab::designer
