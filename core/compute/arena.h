#pragma once

#include "core/compute/buffer.h"

#include <cstdint>
#include <map>

namespace prizma {

/// One device buffer shared by many pieces of data of different lengths: first fit, neighbouring holes merge,
/// grows by half. Kernels get the one buffer and each piece's first item.
template <class T>
class Arena {
  public:
    explicit Arena(std::string what) : what_(std::move(what)) {}

    const Buffer<T>& buffer() const { return buffer_; }

    /// Room for `count` items; gives the first one's index.
    Result<std::uint32_t> allocate(Context& context, std::size_t count) {
        for (auto hole = holes_.begin(); hole != holes_.end(); ++hole) {
            if (hole->second < count)
                continue;
            const auto [first, length] = *hole;
            holes_.erase(hole);
            if (length > count)
                holes_.emplace(first + count, length - count);
            return static_cast<std::uint32_t>(first);
        }
        const std::size_t first = end_;
        if (first + count > buffer_.capacity()) {
            const std::size_t wanted = end_ == 0 ? count : std::max(first + count, end_ + end_ / 2);
            auto ok = buffer_.reserve(context, wanted, what_, end_);
            if (!ok && wanted > first + count)
                ok = buffer_.reserve(context, first + count, what_, end_);
            if (!ok)
                return std::unexpected(ok.error());
        }
        end_ += count;
        return static_cast<std::uint32_t>(first);
    }

    /// Room for `items`, and copies them there.
    Result<std::uint32_t> add(Context& context, std::span<const T> items) {
        const auto first = allocate(context, items.size());
        if (!first)
            return first;
        if (auto ok = buffer_.write(context, items, *first, what_); !ok) {
            release(*first, items.size());
            return std::unexpected(ok.error());
        }
        return first;
    }

    /// Copies `items` to a place that was allocated.
    Result<void> write(Context& context, std::span<const T> items, std::uint32_t first) {
        return buffer_.write(context, items, first, what_);
    }

    /// Gives `count` items at `first` back; they were allocated together.
    void release(std::uint32_t first, std::size_t count) {
        if (count == 0)
            return;
        auto hole = holes_.emplace(first, count).first;
        const auto next = std::next(hole);
        if (next != holes_.end() && hole->first + hole->second == next->first) {
            hole->second += next->second;
            holes_.erase(next);
        }
        if (hole != holes_.begin()) {
            const auto previous = std::prev(hole);
            if (previous->first + previous->second == hole->first) {
                previous->second += hole->second;
                holes_.erase(hole);
                hole = previous;
            }
        }
        if (hole->first + hole->second == end_) {
            end_ = hole->first;
            holes_.erase(hole);
        }
    }

    /// Makes the buffer exist, so that an empty arena can be a kernel's argument.
    Result<void> ensure(Context& context) { return buffer_.reserve(context, 1, what_, end_); }

  private:
    std::string what_;
    Buffer<T> buffer_;
    std::size_t end_ = 0;                      ///< Everything from here on is free.
    std::map<std::size_t, std::size_t> holes_; ///< First free item -> how many, before `end_`.
};

} // namespace prizma
