#include "core/roadmap/found_links.h"

#include <utility>

namespace arcway::internal {

FoundLinks::Row::Row(CheckedRow known) : Row(std::move(known.row), known.around) {
  for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i].store(known.verdicts[i], std::memory_order_relaxed);
}

CheckedRow FoundLinks::Row::checked() const {
  CheckedRow known{row, {}, around};
  known.verdicts.reserve(verdicts.size());
  for (const std::atomic<LinkVerdict>& verdict : verdicts)
    known.verdicts.push_back(verdict.load(std::memory_order_relaxed));
  return known;
}

bool FoundLinks::empty() const {
  bool is_empty = true;
  const auto see = [&](std::size_t, const auto&) { is_empty = false; };
  headings.visit(see);
  rows.visit(see);
  return is_empty;
}

}  // namespace arcway::internal
