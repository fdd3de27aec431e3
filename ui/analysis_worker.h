// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/analysis/analysis.h"
#include "core/analysis/kernels.h"
#include "core/analysis/pipeline.h"
#include "core/scene/scene.h"

namespace ui {

/// An analysis and the scene it was made from.
struct AnalysisResult {
    std::uint64_t generation = 0;  ///< Workspace::generation of `scene`
    core::Scene scene;
    std::shared_ptr<const core::Analysis> analysis;
    core::Notes notes;  ///< about the device that computed it
};

/// Runs core::AnalysisPipeline on a thread of its own. A mailbox with one slot: only the latest request waits. The
/// current one is finished, so that dragging a slider shows intermediate results, unless it belongs to another
/// photograph.
class AnalysisWorker : public QObject {
    Q_OBJECT
  public:
    explicit AnalysisWorker(QObject* parent = nullptr);
    ~AnalysisWorker() override;

    /// Creates the kernels for the expensive parts of the analysis, nullptr = the CPU. Called on the worker's thread at
    /// the start of the first analysis, and again after it has thrown, which fails the analysis with its message. Set
    /// before any request.
    using MakeKernels = std::function<std::unique_ptr<core::AnalysisKernels>()>;
    void setKernels(MakeKernels makeKernels) { makeKernels_ = std::move(makeKernels); }

    /// Replaces a waiting request. From the owner's thread.
    void request(std::uint64_t generation, const core::Scene& scene);
    /// Drops the waiting request and stops the current one.
    void cancel();

  signals:
    void progress(const QString& step, double fraction);
    void finished(std::shared_ptr<const ui::AnalysisResult> result);
    void failed(quint64 generation, const QString& sentence);

  private:
    struct Request {
        std::uint64_t generation = 0;
        core::Scene scene;
    };
    void loop();
    void analyse(const Request& request);

    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<Request> waiting_;              ///< guarded by mutex_
    std::shared_ptr<const core::Photo> current_;  ///< guarded by mutex_
    bool quit_ = false;                           ///< guarded by mutex_
    std::atomic<bool> cancel_ = false;
    MakeKernels makeKernels_;                         ///< empty once it was called with success
    std::unique_ptr<core::AnalysisKernels> kernels_;  ///< used by the thread only
    core::AnalysisPipeline pipeline_;                 ///< used by the thread only
    std::thread thread_;
};

}  // namespace ui
