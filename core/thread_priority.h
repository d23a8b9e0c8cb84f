#pragma once

namespace prizma {

/// Lowers the calling thread's priority, and that of all threads it starts from now on, so that the user
/// interface keeps its share of a busy machine. Without effect where the system does not allow it.
void lowerThreadPriority();

} // namespace prizma
