#pragma once

#include <atomic>

namespace prizma {

/// Shared between a long piece of work and whoever waits for it: the work reports how far it is and stops
/// soon after it was cancelled. Safe from any thread.
class Progress {
  public:
    void set(double fraction) { fraction_.store(fraction, std::memory_order_relaxed); }
    double fraction() const { return fraction_.load(std::memory_order_relaxed); } ///< 0 to 1.

    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  private:
    std::atomic<double> fraction_{0.0};
    std::atomic<bool> cancelled_{false};
};

} // namespace prizma
