#pragma once

#include <atomic>

namespace prizma {

/// Shared between a long piece of work and whoever waits for it: the work reports how far it is and stops
/// soon after it was cancelled. Safe from any thread.
class Progress {
  public:
    void set(double fraction) {
        fraction_.store(from_ + (to_ - from_) * fraction, std::memory_order_relaxed);
    }
    double fraction() const { return fraction_.load(std::memory_order_relaxed); } ///< 0 to 1.

    /// What `set` says from now on is about the part from `from` to `to`. For the working thread alone.
    void beginPart(double from, double to) {
        from_ = from;
        to_ = to;
    }

    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  private:
    std::atomic<double> fraction_{0.0};
    std::atomic<bool> cancelled_{false};
    double from_ = 0.0, to_ = 1.0;
};

/// A step of a longer piece of work: its own 0 to 1 is a part of the whole.
class ProgressPart {
  public:
    explicit ProgressPart(Progress& whole, double from = 0.0, double to = 1.0)
        : whole_(whole), from_(from), to_(to) {}

    void set(double fraction) const { whole_.set(from_ + (to_ - from_) * fraction); }
    bool isCancelled() const { return whole_.isCancelled(); }

    /// The part of this part from `from` to `to`.
    ProgressPart part(double from, double to) const {
        return ProgressPart(whole_, from_ + (to_ - from_) * from, from_ + (to_ - from_) * to);
    }

  private:
    Progress& whole_;
    double from_, to_;
};

} // namespace prizma
