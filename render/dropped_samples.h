// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "gpu/buffer.h"
#include "gpu/command_encoder.h"
#include "gpu/device.h"

namespace render {

/// Number of paths that kernels left out as NaN or Inf, read back while rendering goes on.
class DroppedSamples {
  public:
    explicit DroppedSamples(const gpu::Device& device);

    /// One uint that kernels count in.
    [[nodiscard]] const gpu::Buffer& buffer() const { return count_; }
    /// The count may have grown.
    void pathsRecorded() { reader_->unread = true; }
    /// Begins to read the count back unless it is known or being read; true while another reading has to follow.
    bool record(const gpu::CommandEncoder& encoder);
    /// The count as far as it has arrived.
    [[nodiscard]] std::uint64_t value() const { return reader_->value; }

  private:
    /// Outlives the renderer while a reading is under way.
    struct Reader {
        gpu::Buffer staging;
        bool pending = false;
        bool unread = false;
        std::uint64_t value = 0;
    };
    gpu::Buffer count_;
    std::shared_ptr<Reader> reader_ = std::make_shared<Reader>();
};

}  // namespace render
