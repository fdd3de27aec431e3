// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gpu/command_encoder.h"
#include "gpu/device.h"

namespace gpu {

/// Measures the time of labelled regions on the device, without ever waiting for it.
///
/// Results arrive when the work has completed, for own submissions (device.tick()) and for adopted frames (when the
/// frame's slot begins again). On a device without timestamps `supported()` is false and nothing is reported.
class PassTimer {
  public:
    /// At most `capacity` regions may be in flight at once; further ones are only counted in `dropped`.
    explicit PassTimer(const Device& device, std::uint32_t capacity = 64);

    struct Timing {
        std::string label;
        double seconds = 0;
    };

    /// A region being measured; ends with `end` or with the object. No pass may be open at either end.
    class Region {
      public:
        Region(Region&& other) noexcept;
        Region& operator=(Region&&) = delete;
        ~Region();
        void end();

      private:
        friend class PassTimer;
        struct Data;
        explicit Region(std::unique_ptr<Data> data);
        std::unique_ptr<Data> data_;
    };

    [[nodiscard]] bool supported() const;
    [[nodiscard]] Region measure(const CommandEncoder& encoder, std::string label);
    /// Results since the last call, in order of completion.
    [[nodiscard]] std::vector<Timing> takeResults();
    [[nodiscard]] std::uint64_t dropped() const;

  private:
    struct State;
    std::shared_ptr<State> state_;
};

}  // namespace gpu
