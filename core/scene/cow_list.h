#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace prizma {

/// A copy-on-write list: copying it copies one pointer, so that a snapshot of a scene with ten thousand
/// objects costs no more than one of an empty scene. Reading is const; `edit()` is the only way to change it.
/// A copy may be read in one thread while another copy is edited in a second.
template <class T>
class CowList {
  public:
    CowList() = default;
    CowList(std::initializer_list<T> items) : items_(std::make_shared<std::vector<T>>(items)) {}

    const std::vector<T>& items() const {
        static const std::vector<T> none;
        return items_ ? *items_ : none;
    }

    /// The list for changing; it is copied first if a snapshot shares it.
    std::vector<T>& edit() {
        if (!items_)
            items_ = std::make_shared<std::vector<T>>();
        else if (items_.use_count() > 1)
            items_ = std::make_shared<std::vector<T>>(*items_);
        return *items_;
    }

    auto begin() const { return items().begin(); }
    auto end() const { return items().end(); }
    std::size_t size() const { return items().size(); }
    bool empty() const { return items().empty(); }
    const T& operator[](std::size_t index) const { return items()[index]; }
    const T& back() const { return items().back(); }

    /// True if both are the same list in memory: equal without a look at the items.
    bool shares(const CowList& other) const { return items_ == other.items_; }

    friend bool operator==(const CowList& a, const CowList& b) {
        return a.shares(b) || a.items() == b.items();
    }

  private:
    std::shared_ptr<std::vector<T>> items_;
};

} // namespace prizma
