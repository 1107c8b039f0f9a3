#pragma once
/// \file
/// The last few results of an expensive function, for several threads: one makes a value, the others that
/// want the same wait for it, and nobody else waits.

#include <algorithm>
#include <deque>
#include <future>
#include <mutex>
#include <string>
#include <utility>

namespace mrpp
{

template <class T>
class RecentCache
{
public:
    /// \param capacity how many values to keep; 1 or more
    explicit RecentCache(std::size_t capacity) : capacity_(capacity) {}

    /// The value under that key, made by `make()` where it is not among the last few. What make() throws
    /// reaches all who wait for it, and the next caller tries again.
    template <class Make>
    T get(const std::string &key, Make &&make)
    {
        std::promise<T> promise;
        {
            std::unique_lock lock(mutex_);
            const auto found = find(key);
            if (found != entries_.end())
            {
                const std::shared_future<T> value = found->second;
                lock.unlock();
                return value.get();
            }
            entries_.emplace_back(key, promise.get_future().share());
            if (entries_.size() > capacity_)
                entries_.pop_front();
        }
        try
        {
            T value = make();
            promise.set_value(value);
            return value;
        }
        catch (...)
        {
            promise.set_exception(std::current_exception());
            const std::lock_guard lock(mutex_);
            if (const auto found = find(key); found != entries_.end())
                entries_.erase(found);
            throw;
        }
    }

private:
    using Entries = std::deque<std::pair<std::string, std::shared_future<T>>>; // oldest first

    auto find(const std::string &key)
    {
        return std::find_if(entries_.begin(), entries_.end(),
                            [&key](const auto &entry) { return entry.first == key; });
    }

    std::size_t capacity_;
    std::mutex mutex_;
    Entries entries_;
};

} // namespace mrpp
