#pragma once

namespace prizma {

/// Has PoCL keep each of its worker threads on a processor of its own. Left to themselves two of them at
/// times share one while another idles, for many launches on end: launches of a few milliseconds are over
/// before the system spreads them again. The user's POCL_AFFINITY wins. Does nothing where the process may
/// not use all processors, as PoCL counts them from the first. For the start of a program, before there are
/// other threads: it changes the environment.
void keepDeviceWorkersApart();

} // namespace prizma
