#include "ui/viewport/frame_meter.h"

#include <algorithm>
#include <chrono>

namespace prizma {
namespace {

constexpr qint64 window = 1000; // ms
constexpr std::chrono::milliseconds updateInterval{250};

} // namespace

FrameMeter::FrameMeter(QObject* parent) : QObject(parent), timer_(this) {
    clock_.start();
    timer_.setInterval(updateInterval);
    connect(&timer_, &QTimer::timeout, this, &FrameMeter::update);
}

void FrameMeter::noteFrame() {
    shown_.push_back(clock_.elapsed());
    if (!timer_.isActive())
        timer_.start();
}

double FrameMeter::framesPerSecond() const {
    const qint64 start = clock_.elapsed() - window;
    const auto first = std::upper_bound(shown_.begin(), shown_.end(), start);
    return static_cast<double>(shown_.end() - first);
}

void FrameMeter::update() {
    const qint64 start = clock_.elapsed() - window;
    shown_.erase(shown_.begin(), std::upper_bound(shown_.begin(), shown_.end(), start));
    if (shown_.empty())
        timer_.stop();
    Q_EMIT updated(framesPerSecond());
}

} // namespace prizma
