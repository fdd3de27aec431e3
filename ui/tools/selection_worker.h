// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/base/progress.h"
#include "core/scene/scene.h"
#include "core/selection/selector.h"

namespace ui {

/// Selects in the open photograph on a thread of its own. Prepares a core::Selector for each photograph at once, so
/// that the first click finds it. Changes are made in the order of their requests; of previews only the latest counts,
/// and only when no change waits.
class SelectionWorker : public QObject {
    Q_OBJECT
  public:
    /// Runs on the worker's thread; `selector` is that of the photograph.
    using Work = std::function<void(const core::Selector& selector, const core::Progress& progress)>;
    using Done = std::function<void()>;

    explicit SelectionWorker(QObject* parent = nullptr);
    ~SelectionWorker() override;

    /// Drops all work for another photograph. One with other labels only is the same. nullptr = none.
    void setPhoto(const std::shared_ptr<const core::Photo>& photo);
    /// Runs `work`, then `done` on the owner's thread, unless another photograph has been set.
    void change(Work work, Done done);
    /// Replaces the waiting preview, and stops the running one.
    void preview(Work work, Done done);
    /// Neither the waiting nor the running preview is shown.
    void dropPreview();
    /// Drops all changes that are not done.
    void cancel();

    /// Whether the photograph's selector is known.
    [[nodiscard]] bool prepared() const { return prepared_; }
    /// Whether anything is prepared or selected, previews aside.
    [[nodiscard]] bool busy() const { return unfinished_ > 0; }
    /// Whether changes are waiting or running.
    [[nodiscard]] bool changing() const;

  signals:
    /// `prepared` or `busy` has another value.
    void stateChanged();
    void progress(const QString& step, double fraction);
    void failed(const QString& sentence);

  private:
    struct Job {
        Work work;
        Done done;
        std::uint64_t photoNumber = 0;
    };
    void loop();
    void prepare(const std::shared_ptr<const core::Photo>& photo, std::uint64_t number);
    void run(Job job, bool isPreview);
    /// On the owner's thread.
    void finish(const std::function<void()>& then);
    [[nodiscard]] core::Progress progressOf(std::atomic<bool>& cancel);

    std::mutex mutex_;
    std::condition_variable wake_;
    std::shared_ptr<const core::Photo> wanted_;  ///< guarded by mutex_: to be prepared
    std::deque<Job> changes_;                    ///< guarded by mutex_
    std::optional<Job> preview_;                 ///< guarded by mutex_
    bool quit_ = false;                          ///< guarded by mutex_
    std::atomic<std::uint64_t> photoNumber_ = 0;
    std::atomic<std::uint64_t> previewNumber_ = 0;
    std::atomic<bool> cancelPreparation_ = false;
    std::atomic<bool> cancelChange_ = false;
    std::atomic<bool> cancelPreview_ = false;
    std::optional<core::Selector> selector_;    ///< used by the thread only
    std::shared_ptr<const core::Photo> photo_;  ///< used by the owner only
    bool prepared_ = false;                     ///< used by the owner only
    int unfinished_ = 0;                        ///< used by the owner only
    std::thread thread_;
};

}  // namespace ui
