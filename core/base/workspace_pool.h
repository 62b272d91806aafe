#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace arcway::internal {

/// Workspaces that are lent to queries and used again: as many as there ever were queries at once. Thread-safe.
template <class Workspace>
class WorkspacePool {
 public:
  /// A workspace, borrowed for the lifetime of this object.
  class Lease {
   public:
    explicit Lease(WorkspacePool& pool) : pool_(pool), workspace_(pool.take()) {}
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    ~Lease() { pool_.put_back(std::move(workspace_)); }
    Workspace* operator->() { return &workspace_; }
    Workspace& operator*() { return workspace_; }

   private:
    WorkspacePool& pool_;
    Workspace workspace_;
  };

 private:
  Workspace take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) {
      idle_.reserve(++count_);  // so that none needs memory to come back
      return {};
    }
    Workspace workspace = std::move(idle_.back());
    idle_.pop_back();
    return workspace;
  }
  void put_back(Workspace&& workspace) noexcept {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(workspace));
  }

  std::mutex mutex_;
  std::vector<Workspace> idle_;
  std::size_t count_ = 0;  // of all workspaces
};

}  // namespace arcway::internal
