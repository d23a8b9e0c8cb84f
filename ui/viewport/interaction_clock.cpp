#include "ui/viewport/interaction_clock.h"

#include <chrono>

namespace prizma {
namespace {

constexpr std::chrono::milliseconds pause{200}; // People rest a hand longer than this when they are done.

} // namespace

InteractionClock::InteractionClock(QObject* parent) : QObject(parent), timer_(this) {
    timer_.setSingleShot(true);
    timer_.setInterval(pause);
    connect(&timer_, &QTimer::timeout, this, &InteractionClock::ended);
}

void InteractionClock::noteChange() {
    if (sinceChange_.isValid() && !sinceChange_.hasExpired(pause.count()))
        timer_.start();
    sinceChange_.start();
}

} // namespace prizma
