#pragma once

#include <cstdint>
#include <vector>

#include "arcway/path.h"
#include "core/attach/search_attachments.h"
#include "core/attach/search_context.h"
#include "core/attach/search_options.h"
#include "core/search/arrival_labels.h"

namespace arcway::internal {

/// What a path turns around on a circle, and to which side. See Way.
std::uint32_t turn_on(const Roadmap& map, std::uint32_t circle);

/// The path through a label of a search. All must outlive it.
class ArrivalPath {
 public:
  /// @param chain  is overwritten: memory for the labels of the path.
  ArrivalPath(const SearchContext& context, const SearchAttachments& attachments, const ArrivalLabels& labels,
              std::vector<std::uint32_t>& chain)
      : context_(context), attachments_(attachments), labels_(labels), chain_(chain) {}

  /// Writes the path through a label and the link to a goal that follows, with its circles and its way, into a result.
  /// @param path  whose memory it takes.
  void write(std::uint32_t last, const AttachmentLink& goal, Path path, SearchResult& result);

 private:
  [[nodiscard]] Way way() const;
  void append_start(Path& path) const;
  void append_graph(const AttachmentLink& goal, Path& path) const;
  void append_goal(const AttachmentLink& goal, Path& path) const;

  const SearchContext& context_;
  const SearchAttachments& attachments_;
  const ArrivalLabels& labels_;
  std::vector<std::uint32_t>& chain_;  // last first
};

}  // namespace arcway::internal
