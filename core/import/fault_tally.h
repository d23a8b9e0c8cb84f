#pragma once

#include "core/diagnostic.h"

#include <string>
#include <string_view>
#include <vector>

namespace prizma {

/// Gathers the faults of one file that its reader puts up with. Those of one kind become one warning with the
/// line of the first and their number, so that a bad file gives a few lines and not a million.
class FaultTally {
  public:
    /// `message` tells the kinds apart: a whole sentence of fixed text.
    void add(std::string_view message, int line);

    Diagnostics warnings(const std::string& file) const;

  private:
    struct Kind {
        std::string_view message;
        int firstLine = 0;
        std::size_t count = 0;
    };
    std::vector<Kind> kinds_;
};

/// "a, b, c and 7 more": names for a message, however many there are.
std::string listOf(const std::vector<std::string>& names);

} // namespace prizma
