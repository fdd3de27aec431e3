// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>

namespace test {

/// Longest time the event loop did not come round [ms].
class StallMeter {
  public:
    StallMeter() {
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { lap(); });
        timer_.start(1);
        clock_.start();
    }
    qint64 longest() {
        lap();
        return longest_;
    }
    void reset() {
        clock_.restart();
        longest_ = 0;
    }

  private:
    void lap() { longest_ = std::max(longest_, clock_.restart()); }
    QTimer timer_;
    QElapsedTimer clock_;
    qint64 longest_ = 0;
};

}  // namespace test
