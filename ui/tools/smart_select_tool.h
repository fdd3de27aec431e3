// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/tools/tool.h"

namespace ui {

/// Selects the object under the pointer: a click adds, with Alt it removes, a drag points at several places. Shows
/// beforehand what a click would select.
class SmartSelectTool : public Tool {
    Q_OBJECT
  public:
    explicit SmartSelectTool(SelectionSession& session, QObject* parent = nullptr);

    [[nodiscard]] QString hint() const override;
    void press(const ToolEvent& event) override;
    void drag(const QPointF& position) override;
    void release() override;
    void hover(const ToolEvent& event) override;
    void leave() override;
    bool cancel() override;

  private:
    /// The latest selection asked for: of the document, or of a click that is still being worked on.
    [[nodiscard]] std::shared_ptr<const core::PixelSelection> latest() const;
    /// `latest` with more seeds. The newest seed of a pixel counts.
    [[nodiscard]] core::PixelSelection with(const std::vector<core::Pixel>& seeds, bool removes) const;
    void addSeed(const core::Pixel& pixel);

    struct Stroke {
        std::vector<core::Pixel> seeds;
        bool removes = false;
    };
    std::optional<Stroke> stroke_;
    std::shared_ptr<const core::PixelSelection> asked_;  ///< by the last click; counts while the worker is busy
    std::optional<core::Pixel> hovered_;
    bool hoverRemoves_ = false;
};

}  // namespace ui
